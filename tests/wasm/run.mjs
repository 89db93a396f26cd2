// node run.mjs MODULE [FAULT]: prints the checksums of a wasm module, one a line, as the native program does.
import {readFileSync} from 'node:fs';

const [module, fault = '0'] = process.argv.slice(2);
const {instance} = await WebAssembly.instantiate(readFileSync(module), {});
const {checksum, step_count} = instance.exports;
for (let step = 0; step < step_count(); step++) {
    const sum = BigInt.asUintN(64, checksum(step, Number(fault)));
    console.log(sum.toString(16).padStart(16, '0'));
}
