struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_51 {
    member: type_28,
    member_1: f32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_56 {
    member: array<vec4<u32>, 2>,
}

struct type_59 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_56;
@group(0) @binding(2) 
var<storage> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_59;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<u32, 128>;
    var local_1: array<f32, 128>;
    var phi_268_: type_46;
    var phi_378_: i32;
    var phi_379_: i32;
    var phi_389_: bool;
    var phi_399_: u32;
    var phi_400_: u32;
    var phi_402_: bool;
    var phi_407_: u32;
    var phi_451_: f32;
    var phi_457_: f32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_497_: f32;
    var phi_508_: f32;
    var phi_517_: f32;
    var phi_523_: f32;
    var phi_534_: f32;
    var phi_540_: f32;
    var phi_563_: f32;
    var phi_574_: f32;
    var phi_583_: f32;
    var phi_589_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_629_: f32;
    var phi_640_: f32;
    var phi_740_: f32;
    var phi_741_: f32;
    var phi_2543_: bool;
    var phi_752_: type_51;
    var phi_755_: u32;
    var phi_757_: u32;
    var phi_759_: bool;
    var phi_761_: u32;
    var phi_772_: bool;
    var phi_802_: u32;
    var phi_803_: bool;
    var phi_804_: u32;
    var phi_1986_: type_54;
    var phi_2330_: u32;
    var phi_2356_: u32;
    var phi_2357_: u32;
    var phi_2358_: u32;
    var phi_2360_: u32;
    var phi_2361_: u32;
    var phi_2362_: bool;
    var phi_2371_: u32;
    var phi_2376_: u32;
    var phi_2377_: bool;
    var phi_820_: type_51;
    var phi_823_: type_8;
    var phi_824_: type_8;
    var phi_846_: type_8;
    var phi_866_: u32;
    var phi_954_: array<array<f32, 3>, 3>;
    var phi_1425_: vec3<f32>;
    var phi_1426_: vec3<f32>;
    var phi_1457_: bool;
    var phi_1466_: vec3<f32>;
    var phi_1506_: type_28;
    var phi_1508_: type_28;
    var phi_1509_: bool;
    var phi_1513_: type_28;
    var phi_1514_: type_28;
    var phi_1515_: type_28;
    var phi_1516_: bool;
    var phi_1520_: type_28;
    var phi_1521_: bool;
    var phi_1525_: type_28;
    var phi_1526_: bool;
    var phi_1530_: type_28;
    var phi_1553_: u32;
    var phi_1567_: i32;
    var phi_1659_: array<array<f32, 3>, 3>;
    var phi_1697_: vec3<f32>;
    var phi_1879_: f32;
    var phi_1897_: bool;
    var phi_1898_: bool;
    var phi_1917_: bool;
    var phi_1918_: bool;
    var phi_1924_: type_51;
    var phi_1925_: type_51;
    var phi_1926_: type_51;
    var phi_821_: type_51;
    var phi_2537_: bool;
    var phi_2667_: bool;
    var phi_2379_: type_51;
    var phi_2380_: u32;
    var phi_2381_: bool;
    var phi_2382_: u32;
    var phi_2666_: bool;
    var phi_2383_: type_51;
    var phi_2384_: u32;
    var phi_2385_: u32;
    var phi_2386_: bool;
    var phi_2387_: u32;
    var phi_2665_: bool;
    var phi_2388_: type_51;
    var phi_2389_: u32;
    var phi_2390_: u32;
    var phi_2391_: bool;
    var phi_2392_: u32;
    var phi_2664_: bool;
    var phi_753_: type_51;
    var phi_756_: u32;
    var phi_758_: u32;
    var phi_760_: bool;
    var phi_762_: u32;
    var phi_2393_: bool;
    var phi_2663_: bool;
    var local_2: type_51;
    var phi_2445_: type_28;
    var local_3: type_51;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_3.member));
            let _e77 = arrayLength((&global_4.member));
            let _e89 = arrayLength((&global_9.member));
            let _e93 = (_e73.x + (_e73.y * 2097152u));
            let _e94 = (_e93 < arrayLength((&global_7.member)));
            if _e94 {
                let _e95 = (_e93 < arrayLength((&global_8.member)));
                if _e95 {
                    let _e98 = global_1.member[0u];
                    let _e102 = global_2.member[0u][0u];
                    let _e106 = global_2.member[0u][1u];
                    let _e110 = global_2.member[0u][2u];
                    let _e114 = global_2.member[0u][3u];
                    let _e118 = global_2.member[1u][0u];
                    let _e122 = global_2.member[1u][1u];
                    let _e126 = global_2.member[1u][2u];
                    let _e130 = global_2.member[1u][3u];
                    let _e131 = bitcast<f32>(_e102);
                    let _e132 = bitcast<f32>(_e106);
                    let _e133 = bitcast<f32>(_e110);
                    let _e135 = bitcast<f32>(_e118);
                    let _e136 = array<u32, 3>(_e122, _e126, _e130);
                    let _e138 = bitcast<i32>(_e98);
                    let _e139 = (_e138 / 2i);
                    let _e144 = bitcast<f32>((bitcast<u32>((_e139 + 127i)) << bitcast<u32>(23i)));
                    let _e150 = bitcast<f32>((bitcast<u32>(((_e138 - _e139) + 127i)) << bitcast<u32>(23i)));
                    if (_e114 == 0u) {
                        phi_268_ = type_46(array<f32, 3>(_e131, _e132, _e133), _e114, _e135, _e136);
                    } else {
                        phi_268_ = type_46(array<f32, 3>(((_e131 * _e144) * _e150), ((_e132 * _e144) * _e150), ((_e133 * _e144) * _e150)), _e114, ((_e135 * _e144) * _e150), _e136);
                    }
                    let _e163 = phi_268_;
                    if _e94 {
                    } else {
                        break;
                    }
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e167 = global_7.member[_e93].member_2;
                    let _e177 = global_7.member[_e93].member.member_2[0u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e185 = global_7.member[_e93].member.member_2[1u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e193 = global_7.member[_e93].member.member_2[2u];
                    let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                    let _e201 = global_7.member[_e93].member.member[0u];
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e209 = global_7.member[_e93].member.member[1u];
                    let _e211 = (bitcast<u32>(_e209) & 2147483647u);
                    let _e217 = global_7.member[_e93].member.member[2u];
                    let _e219 = (bitcast<u32>(_e217) & 2147483647u);
                    let _e221 = select(_e187, _e179, (_e187 < _e179));
                    let _e223 = select(_e195, _e221, (_e195 < _e221));
                    let _e225 = select(_e203, _e223, (_e203 < _e223));
                    let _e227 = select(_e211, _e225, (_e211 < _e225));
                    let _e229 = select(_e219, _e227, (_e219 < _e227));
                    let _e234 = global_7.member[_e93].member.member_1;
                    let _e236 = (bitcast<u32>(_e234) & 2147483647u);
                    let _e244 = global_7.member[_e93].member.member_3;
                    let _e250 = (((select(_e236, _e229, (_e236 < _e229)) < 2139095040u) && ((bitcast<u32>(_e244) & 2147483647u) <= 2139095040u)) && (_e223 > 0u));
                    if _e250 {
                        let _e253 = (bitcast<u32>(bitcast<f32>(_e223)) & 2147483647u);
                        if (_e253 >= 8388608u) {
                            phi_378_ = (bitcast<i32>((_e253 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_378_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e253)), 32u, (_e253 == 0u))));
                        }
                        let _e267 = phi_378_;
                        phi_379_ = _e267;
                    } else {
                        phi_379_ = 0i;
                    }
                    let _e269 = phi_379_;
                    let _e270 = (_e179 == _e223);
                    if _e270 {
                        phi_389_ = true;
                    } else {
                        phi_389_ = (_e187 == _e223);
                    }
                    let _e273 = phi_389_;
                    let _e274 = select(1u, 0u, _e270);
                    if _e273 {
                        let _e275 = (_e274 + 1u);
                        phi_399_ = _e275;
                        phi_400_ = _e275;
                        phi_402_ = select(true, false, (_e275 == 2u));
                    } else {
                        phi_399_ = u32();
                        phi_400_ = 0u;
                        phi_402_ = true;
                    }
                    let _e279 = phi_399_;
                    let _e281 = phi_400_;
                    let _e283 = phi_402_;
                    if _e283 {
                        phi_407_ = (_e281 + 1u);
                    } else {
                        phi_407_ = 0u;
                    }
                    let _e287 = phi_407_;
                    let _e288 = select(_e279, _e281, _e283);
                    let _e289 = select(_e274, select(2u, _e274, _e273), _e283);
                    let _e290 = -(_e269);
                    let _e291 = (_e290 / 2i);
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e290 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e307 = global_7.member[_e93].member.member;
                    let _e308 = (_e288 == 0u);
                    if _e308 {
                        phi_451_ = _e307[0];
                    } else {
                        phi_451_ = _e307[1];
                    }
                    let _e312 = phi_451_;
                    let _e313 = (_e288 == 2u);
                    if _e313 {
                        phi_457_ = _e307[2];
                    } else {
                        phi_457_ = _e312;
                    }
                    let _e316 = phi_457_;
                    let _e317 = global_7.member[_e93].member.member_2;
                    if _e308 {
                        phi_468_ = _e317[0];
                    } else {
                        phi_468_ = _e317[1];
                    }
                    let _e321 = phi_468_;
                    if _e313 {
                        phi_474_ = _e317[2];
                    } else {
                        phi_474_ = _e321;
                    }
                    let _e324 = phi_474_;
                    let _e326 = ((_e324 * _e296) * _e302);
                    let _e330 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e330 {
                        let _e334 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) * 0.00000011920929f);
                        phi_497_ = select(0.00000000000011368684f, _e334, (_e334 > 0.00000000000011368684f));
                    } else {
                        phi_497_ = 0f;
                    }
                    let _e338 = phi_497_;
                    let _e339 = (_e316 + _e338);
                    let _e340 = (_e316 - _e338);
                    let _e341 = select(_e326, 0f, _e330);
                    if _e330 {
                        phi_508_ = 38685626000000000000000000f;
                    } else {
                        phi_508_ = (1f / _e326);
                    }
                    let _e344 = phi_508_;
                    let _e345 = (_e287 == 0u);
                    if _e345 {
                        phi_517_ = _e307[0];
                    } else {
                        phi_517_ = _e307[1];
                    }
                    let _e349 = phi_517_;
                    let _e350 = (_e287 == 2u);
                    if _e350 {
                        phi_523_ = _e307[2];
                    } else {
                        phi_523_ = _e349;
                    }
                    let _e353 = phi_523_;
                    if _e345 {
                        phi_534_ = _e317[0];
                    } else {
                        phi_534_ = _e317[1];
                    }
                    let _e357 = phi_534_;
                    if _e350 {
                        phi_540_ = _e317[2];
                    } else {
                        phi_540_ = _e357;
                    }
                    let _e360 = phi_540_;
                    let _e362 = ((_e360 * _e296) * _e302);
                    let _e366 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e366 {
                        let _e370 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) * 0.00000011920929f);
                        phi_563_ = select(0.00000000000011368684f, _e370, (_e370 > 0.00000000000011368684f));
                    } else {
                        phi_563_ = 0f;
                    }
                    let _e374 = phi_563_;
                    let _e375 = (_e353 + _e374);
                    let _e376 = (_e353 - _e374);
                    let _e377 = select(_e362, 0f, _e366);
                    if _e366 {
                        phi_574_ = 38685626000000000000000000f;
                    } else {
                        phi_574_ = (1f / _e362);
                    }
                    let _e380 = phi_574_;
                    let _e381 = (_e289 == 0u);
                    if _e381 {
                        phi_583_ = _e307[0];
                    } else {
                        phi_583_ = _e307[1];
                    }
                    let _e385 = phi_583_;
                    let _e386 = (_e289 == 2u);
                    if _e386 {
                        phi_589_ = _e307[2];
                    } else {
                        phi_589_ = _e385;
                    }
                    let _e389 = phi_589_;
                    if _e381 {
                        phi_600_ = _e317[0];
                    } else {
                        phi_600_ = _e317[1];
                    }
                    let _e393 = phi_600_;
                    if _e386 {
                        phi_606_ = _e317[2];
                    } else {
                        phi_606_ = _e393;
                    }
                    let _e396 = phi_606_;
                    let _e398 = ((_e396 * _e296) * _e302);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_629_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_629_ = 0f;
                    }
                    let _e410 = phi_629_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_640_ = 38685626000000000000000000f;
                    } else {
                        phi_640_ = (1f / _e398);
                    }
                    let _e416 = phi_640_;
                    let _e419 = bitcast<f32>((bitcast<u32>(_e316) & 2147483647u));
                    let _e422 = bitcast<f32>((bitcast<u32>(_e353) & 2147483647u));
                    let _e424 = select(_e422, _e419, (_e419 > _e422));
                    let _e427 = bitcast<f32>((bitcast<u32>(_e389) & 2147483647u));
                    if (_e250 && (select(_e427, _e424, (_e424 > _e427)) <= 1099511600000f)) {
                        let _e432 = (_e269 / 3i);
                        let _e439 = bitcast<f32>((bitcast<u32>((_e432 + 127i)) << bitcast<u32>(23i)));
                        let _e446 = bitcast<f32>((bitcast<u32>(((_e269 - (2i * _e432)) + 127i)) << bitcast<u32>(23i)));
                        let _e447 = (((_e234 * _e439) * _e439) * _e446);
                        let _e449 = select(340282350000000000000000000000000000000f, _e447, (_e447 < 340282350000000000000000000000000000000f));
                        let _e454 = (((_e244 * _e439) * _e439) * _e446);
                        let _e456 = select(340282350000000000000000000000000000000f, _e454, (_e454 < 340282350000000000000000000000000000000f));
                        phi_740_ = select(-340282350000000000000000000000000000000f, _e456, (_e456 > -340282350000000000000000000000000000000f));
                        phi_741_ = select(-340282350000000000000000000000000000000f, _e449, (_e449 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_740_ = 0f;
                        phi_741_ = 1f;
                    }
                    let _e460 = phi_740_;
                    let _e462 = phi_741_;
                    local = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2543_ = false;
                    phi_752_ = type_51(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e460);
                    phi_755_ = select(0u, 2147483648u, (_e75 == 0u));
                    phi_757_ = ((3u * _e75) + 1u);
                    phi_759_ = (_e462 <= _e460);
                    phi_761_ = 0u;
                    loop {
                        let _e470 = phi_2543_;
                        let _e472 = phi_752_;
                        let _e474 = phi_755_;
                        let _e476 = phi_757_;
                        let _e478 = phi_759_;
                        let _e480 = phi_761_;
                        local_2 = _e472;
                        if _e478 {
                            phi_772_ = true;
                        } else {
                            phi_772_ = (_e480 > 0u);
                        }
                        let _e483 = phi_772_;
                        if _e483 {
                            let _e484 = (_e476 > 0u);
                            if _e484 {
                                if _e478 {
                                    phi_802_ = _e474;
                                    phi_803_ = _e478;
                                    phi_804_ = _e480;
                                } else {
                                    let _e485 = (_e480 - 1u);
                                    let _e486 = (_e485 % 128u);
                                    let _e487 = (_e486 < 128u);
                                    if _e487 {
                                    } else {
                                        phi_2663_ = true;
                                        break;
                                    }
                                    let _e489 = local[_e486];
                                    if _e487 {
                                    } else {
                                        phi_2663_ = true;
                                        break;
                                    }
                                    let _e491 = local_1[_e486];
                                    phi_802_ = _e489;
                                    phi_803_ = (_e491 <= _e472.member_1);
                                    phi_804_ = _e485;
                                }
                                let _e495 = phi_802_;
                                let _e497 = phi_803_;
                                let _e499 = phi_804_;
                                if _e497 {
                                    let _e503 = (_e495 & 268435455u);
                                    if ((_e495 & 2147483648u) != 0u) {
                                        phi_820_ = _e472;
                                        phi_823_ = type_8(_e503, (_e503 + ((_e495 >> bitcast<u32>(28u)) & 7u)));
                                        loop {
                                            let _e698 = phi_820_;
                                            let _e700 = phi_823_;
                                            local_3 = _e698;
                                            if (_e700.member < _e700.member_1) {
                                                phi_824_ = type_8((_e700.member + 1u), _e700.member_1);
                                                phi_846_ = type_8(1u, _e700.member);
                                            } else {
                                                phi_824_ = _e700;
                                                phi_846_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e713 = phi_824_;
                                            let _e715 = phi_846_;
                                            let _e719 = (bitcast<i32>(_e715.member) != 0i);
                                            if _e719 {
                                                let _e720 = (_e715.member_1 < _e77);
                                                if _e720 {
                                                    if _e720 {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e724 = global_4.member[_e715.member_1].member_1;
                                                    phi_866_ = _e724;
                                                } else {
                                                    phi_866_ = 4294967295u;
                                                }
                                                let _e726 = phi_866_;
                                                let _e727 = (_e715.member_1 >= _e77);
                                                if _e727 {
                                                    phi_954_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e720 {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e728 = (_e288 % 3u);
                                                    let _e729 = (_e287 % 3u);
                                                    let _e730 = (_e289 % 3u);
                                                    if (_e728 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e736 = global_4.member[_e715.member_1].member[_e728];
                                                    if (_e729 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e742 = global_4.member[_e715.member_1].member[_e729];
                                                    if (_e730 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e748 = global_4.member[_e715.member_1].member[_e730];
                                                    let _e750 = (3u + _e728);
                                                    if (_e750 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e756 = global_4.member[_e715.member_1].member[_e750];
                                                    let _e757 = (3u + _e729);
                                                    if (_e757 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e763 = global_4.member[_e715.member_1].member[_e757];
                                                    let _e764 = (3u + _e730);
                                                    if (_e764 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e770 = global_4.member[_e715.member_1].member[_e764];
                                                    let _e772 = (6u + _e728);
                                                    if (_e772 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e778 = global_4.member[_e715.member_1].member[_e772];
                                                    let _e779 = (6u + _e729);
                                                    if (_e779 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e785 = global_4.member[_e715.member_1].member[_e779];
                                                    let _e786 = (6u + _e730);
                                                    if (_e786 < 9u) {
                                                    } else {
                                                        phi_2537_ = true;
                                                        break;
                                                    }
                                                    let _e792 = global_4.member[_e715.member_1].member[_e786];
                                                    phi_954_ = array<array<f32, 3>, 3>(array<f32, 3>(_e736, _e742, _e748), array<f32, 3>(_e756, _e763, _e770), array<f32, 3>(_e778, _e785, _e792));
                                                }
                                                let _e796 = phi_954_;
                                                let _e804 = (_e796[0][2] - _e389);
                                                let _e807 = (((_e796[0][0] - _e316) * _e413) - (_e804 * _e341));
                                                let _e810 = (((_e796[0][1] - _e353) * _e413) - (_e804 * _e377));
                                                let _e817 = (_e796[1][2] - _e389);
                                                let _e820 = (((_e796[1][0] - _e316) * _e413) - (_e817 * _e341));
                                                let _e823 = (((_e796[1][1] - _e353) * _e413) - (_e817 * _e377));
                                                let _e830 = (_e796[2][2] - _e389);
                                                let _e833 = (((_e796[2][0] - _e316) * _e413) - (_e830 * _e341));
                                                let _e836 = (((_e796[2][1] - _e353) * _e413) - (_e830 * _e377));
                                                let _e837 = (_e833 * _e823);
                                                let _e838 = (_e836 * _e820);
                                                let _e839 = (_e807 * _e836);
                                                let _e840 = (_e810 * _e833);
                                                let _e841 = (_e820 * _e810);
                                                let _e842 = (_e823 * _e807);
                                                let _e847 = (((_e837 >= _e838) && (_e839 >= _e840)) && (_e841 >= _e842));
                                                if (_e847 || (((_e837 <= _e838) && (_e839 <= _e840)) && (_e841 <= _e842))) {
                                                    let _e854 = select(-1f, 1f, _e847);
                                                    let _e856 = ((_e837 - _e838) * _e854);
                                                    let _e858 = select(0f, _e856, (_e856 > 0f));
                                                    let _e860 = ((_e839 - _e840) * _e854);
                                                    let _e862 = select(0f, _e860, (_e860 > 0f));
                                                    let _e864 = ((_e841 - _e842) * _e854);
                                                    let _e866 = select(0f, _e864, (_e864 > 0f));
                                                    let _e868 = ((_e858 + _e862) + _e866);
                                                    if (_e868 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1520_ = type_28();
                                                        phi_1521_ = true;
                                                    } else {
                                                        let _e871 = select(_e796[1][0], _e796[0][0], (_e796[0][0] < _e796[1][0]));
                                                        let _e875 = select(_e796[1][0], _e796[0][0], (_e796[0][0] > _e796[1][0]));
                                                        let _e879 = select(_e796[1][1], _e796[0][1], (_e796[0][1] < _e796[1][1]));
                                                        let _e883 = select(_e796[1][1], _e796[0][1], (_e796[0][1] > _e796[1][1]));
                                                        let _e887 = select(_e796[1][2], _e796[0][2], (_e796[0][2] < _e796[1][2]));
                                                        let _e891 = select(_e796[1][2], _e796[0][2], (_e796[0][2] > _e796[1][2]));
                                                        let _e896 = ((select(_e796[2][0], _e871, (_e871 < _e796[2][0])) - _e339) * _e344);
                                                        let _e897 = ((select(_e796[2][0], _e875, (_e875 > _e796[2][0])) - _e340) * _e344);
                                                        let _e900 = ((select(_e796[2][1], _e879, (_e879 < _e796[2][1])) - _e375) * _e380);
                                                        let _e901 = ((select(_e796[2][1], _e883, (_e883 > _e796[2][1])) - _e376) * _e380);
                                                        let _e904 = ((select(_e796[2][2], _e887, (_e887 < _e796[2][2])) - _e411) * _e416);
                                                        let _e905 = ((select(_e796[2][2], _e891, (_e891 > _e796[2][2])) - _e412) * _e416);
                                                        let _e907 = select(_e905, _e904, (_e904 < _e905));
                                                        let _e909 = select(_e905, _e904, (_e904 > _e905));
                                                        let _e911 = select(_e897, _e896, (_e896 < _e897));
                                                        let _e913 = select(_e901, _e900, (_e900 < _e901));
                                                        let _e915 = select(_e913, _e911, (_e911 > _e913));
                                                        let _e917 = select(_e907, _e915, (_e915 > _e907));
                                                        let _e919 = select(_e897, _e896, (_e896 > _e897));
                                                        let _e921 = select(_e901, _e900, (_e900 > _e901));
                                                        let _e923 = select(_e921, _e919, (_e919 < _e921));
                                                        let _e925 = select(_e909, _e923, (_e923 < _e909));
                                                        let _e926 = -(_e907);
                                                        let _e932 = select(_e462, _e917, (_e917 > _e462));
                                                        if (_e932 > (_e925 + (select(_e926, _e909, (_e909 > _e926)) * 0.0000019073523f))) {
                                                            phi_1515_ = type_28();
                                                            phi_1516_ = true;
                                                        } else {
                                                            let _e934 = (_e932 > _e698.member_1);
                                                            if _e934 {
                                                                phi_1514_ = type_28();
                                                            } else {
                                                                let _e938 = (_e796[1][0] - _e796[0][0]);
                                                                let _e939 = (_e796[1][1] - _e796[0][1]);
                                                                let _e940 = (_e796[1][2] - _e796[0][2]);
                                                                let _e941 = vec3<f32>(_e938, _e939, _e940);
                                                                let _e942 = (_e796[2][0] - _e796[1][0]);
                                                                let _e943 = (_e796[2][1] - _e796[1][1]);
                                                                let _e944 = (_e796[2][2] - _e796[1][2]);
                                                                let _e945 = vec3<f32>(_e942, _e943, _e944);
                                                                let _e946 = (_e796[0][0] - _e796[2][0]);
                                                                let _e947 = (_e796[0][1] - _e796[2][1]);
                                                                let _e948 = (_e796[0][2] - _e796[2][2]);
                                                                let _e949 = vec3<f32>(_e946, _e947, _e948);
                                                                let _e952 = bitcast<f32>((bitcast<u32>(_e938) & 2147483647u));
                                                                let _e955 = bitcast<f32>((bitcast<u32>(_e939) & 2147483647u));
                                                                let _e957 = select(_e955, _e952, (_e952 > _e955));
                                                                let _e960 = bitcast<f32>((bitcast<u32>(_e940) & 2147483647u));
                                                                let _e962 = select(_e960, _e957, (_e957 > _e960));
                                                                let _e965 = bitcast<f32>((bitcast<u32>(_e942) & 2147483647u));
                                                                let _e968 = bitcast<f32>((bitcast<u32>(_e943) & 2147483647u));
                                                                let _e970 = select(_e968, _e965, (_e965 > _e968));
                                                                let _e973 = bitcast<f32>((bitcast<u32>(_e944) & 2147483647u));
                                                                let _e975 = select(_e973, _e970, (_e970 > _e973));
                                                                let _e978 = bitcast<f32>((bitcast<u32>(_e946) & 2147483647u));
                                                                let _e981 = bitcast<f32>((bitcast<u32>(_e947) & 2147483647u));
                                                                let _e983 = select(_e981, _e978, (_e978 > _e981));
                                                                let _e986 = bitcast<f32>((bitcast<u32>(_e948) & 2147483647u));
                                                                let _e988 = select(_e986, _e983, (_e983 > _e986));
                                                                let _e990 = select(_e975, _e962, (_e962 > _e975));
                                                                let _e992 = select(_e988, _e990, (_e990 > _e988));
                                                                if (_e962 == _e992) {
                                                                    phi_1425_ = _e945;
                                                                    phi_1426_ = _e949;
                                                                } else {
                                                                    let _e995 = vec3((_e975 == _e992));
                                                                    phi_1425_ = select(_e941, _e949, _e995);
                                                                    phi_1426_ = select(_e945, _e941, _e995);
                                                                }
                                                                let _e999 = phi_1425_;
                                                                let _e1001 = phi_1426_;
                                                                let _e1008 = ((_e999.y * _e1001.z) - (_e1001.y * _e999.z));
                                                                let _e1013 = ((_e999.z * _e1001.x) - (_e1001.z * _e999.x));
                                                                let _e1016 = ((_e999.x * _e1001.y) - (_e1001.x * _e999.y));
                                                                if (_e858 >= _e862) {
                                                                    phi_1457_ = select(true, false, (_e858 >= _e866));
                                                                } else {
                                                                    phi_1457_ = true;
                                                                }
                                                                let _e1021 = phi_1457_;
                                                                if _e1021 {
                                                                    phi_1466_ = select(vec3<f32>(_e796[2][0], _e796[2][1], _e796[2][2]), vec3<f32>(_e796[1][0], _e796[1][1], _e796[1][2]), vec3((_e862 >= _e866)));
                                                                } else {
                                                                    phi_1466_ = vec3<f32>(_e796[0][0], _e796[0][1], _e796[0][2]);
                                                                }
                                                                let _e1026 = phi_1466_;
                                                                let _e1043 = ((((_e1008 * (_e1026.x - _e316)) + (_e1013 * (_e1026.y - _e353))) + (_e1016 * (_e1026.z - _e389))) / (((_e1008 * _e341) + (_e1013 * _e377)) + (_e1016 * _e413)));
                                                                let _e1045 = select(_e925, _e1043, (_e1043 < _e925));
                                                                let _e1047 = select(_e917, _e1045, (_e1045 > _e917));
                                                                if (_e1047 >= _e462) {
                                                                    let _e1049 = (_e1047 <= _e698.member_1);
                                                                    if _e1049 {
                                                                        let _e1050 = (1f / _e868);
                                                                        phi_1506_ = type_28(_e1047, (_e862 * _e1050), (_e866 * _e1050), _e726);
                                                                    } else {
                                                                        phi_1506_ = type_28();
                                                                    }
                                                                    let _e1055 = phi_1506_;
                                                                    phi_1508_ = _e1055;
                                                                    phi_1509_ = select(true, false, _e1049);
                                                                } else {
                                                                    phi_1508_ = type_28();
                                                                    phi_1509_ = true;
                                                                }
                                                                let _e1058 = phi_1508_;
                                                                let _e1060 = phi_1509_;
                                                                if _e1060 {
                                                                    phi_1513_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1513_ = _e1058;
                                                                }
                                                                let _e1062 = phi_1513_;
                                                                phi_1514_ = _e1062;
                                                            }
                                                            let _e1064 = phi_1514_;
                                                            phi_1515_ = _e1064;
                                                            phi_1516_ = _e934;
                                                        }
                                                        let _e1066 = phi_1515_;
                                                        let _e1068 = phi_1516_;
                                                        phi_1520_ = _e1066;
                                                        phi_1521_ = _e1068;
                                                    }
                                                    let _e1070 = phi_1520_;
                                                    let _e1072 = phi_1521_;
                                                    phi_1525_ = _e1070;
                                                    phi_1526_ = _e1072;
                                                } else {
                                                    phi_1525_ = type_28();
                                                    phi_1526_ = true;
                                                }
                                                let _e1074 = phi_1525_;
                                                let _e1076 = phi_1526_;
                                                if _e1076 {
                                                    phi_1530_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1530_ = _e1074;
                                                }
                                                let _e1078 = phi_1530_;
                                                if (_e1078.member_3 != 4294967295u) {
                                                    if (_e726 == _e167) {
                                                        phi_1898_ = false;
                                                    } else {
                                                        let _e1082 = (_e726 < arrayLength((&global_5.member)));
                                                        if _e1082 {
                                                            if _e1082 {
                                                            } else {
                                                                phi_2537_ = true;
                                                                break;
                                                            }
                                                            let _e1084 = global_5.member[_e726];
                                                            phi_1553_ = _e1084;
                                                        } else {
                                                            phi_1553_ = 4294967295u;
                                                        }
                                                        let _e1086 = phi_1553_;
                                                        let _e1087 = (_e1086 < arrayLength((&global_6.member)));
                                                        if _e1087 {
                                                            if _e1087 {
                                                            } else {
                                                                phi_2537_ = true;
                                                                break;
                                                            }
                                                            let _e1089 = global_6.member[_e1086];
                                                            phi_1567_ = _e1089;
                                                        } else {
                                                            phi_1567_ = 0i;
                                                        }
                                                        let _e1091 = phi_1567_;
                                                        let _e1092 = (_e1091 == 0i);
                                                        if _e1092 {
                                                            phi_1897_ = true;
                                                        } else {
                                                            if _e727 {
                                                                phi_1659_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                            } else {
                                                                if _e720 {
                                                                } else {
                                                                    phi_2537_ = true;
                                                                    break;
                                                                }
                                                                let _e1097 = global_4.member[_e715.member_1].member[0u];
                                                                let _e1102 = global_4.member[_e715.member_1].member[1u];
                                                                let _e1107 = global_4.member[_e715.member_1].member[2u];
                                                                let _e1113 = global_4.member[_e715.member_1].member[3u];
                                                                let _e1118 = global_4.member[_e715.member_1].member[4u];
                                                                let _e1123 = global_4.member[_e715.member_1].member[5u];
                                                                let _e1129 = global_4.member[_e715.member_1].member[6u];
                                                                let _e1134 = global_4.member[_e715.member_1].member[7u];
                                                                let _e1139 = global_4.member[_e715.member_1].member[8u];
                                                                phi_1659_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1097, _e1102, _e1107), array<f32, 3>(_e1113, _e1118, _e1123), array<f32, 3>(_e1129, _e1134, _e1139));
                                                            }
                                                            let _e1143 = phi_1659_;
                                                            let _e1156 = (_e1143[1][0] - _e1143[0][0]);
                                                            let _e1157 = (_e1143[1][1] - _e1143[0][1]);
                                                            let _e1158 = (_e1143[1][2] - _e1143[0][2]);
                                                            let _e1159 = (_e1143[2][0] - _e1143[0][0]);
                                                            let _e1160 = (_e1143[2][1] - _e1143[0][1]);
                                                            let _e1161 = (_e1143[2][2] - _e1143[0][2]);
                                                            if (_e163.member_1 == 1u) {
                                                                phi_1697_ = vec3<f32>((_e163.member[0] - _e1143[0][0]), (_e163.member[1] - _e1143[0][1]), (_e163.member[2] - _e1143[0][2]));
                                                            } else {
                                                                phi_1697_ = vec3<f32>(_e163.member[0], _e163.member[1], _e163.member[2]);
                                                            }
                                                            let _e1178 = phi_1697_;
                                                            let _e1184 = bitcast<f32>((bitcast<u32>((_e1156 * _e1160)) ^ _e163.member_3[0]));
                                                            let _e1188 = bitcast<f32>((bitcast<u32>((_e1157 * _e1159)) ^ _e163.member_3[0]));
                                                            let _e1192 = bitcast<f32>((bitcast<u32>((_e1157 * _e1161)) ^ _e163.member_3[0]));
                                                            let _e1196 = bitcast<f32>((bitcast<u32>((_e1158 * _e1160)) ^ _e163.member_3[0]));
                                                            let _e1200 = bitcast<f32>((bitcast<u32>((_e1158 * _e1159)) ^ _e163.member_3[0]));
                                                            let _e1204 = bitcast<f32>((bitcast<u32>((_e1156 * _e1161)) ^ _e163.member_3[0]));
                                                            let _e1205 = (_e1192 - _e1196);
                                                            let _e1206 = (_e1200 - _e1204);
                                                            let _e1207 = (_e1184 - _e1188);
                                                            let _e1231 = (bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u)));
                                                            let _e1238 = (bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u)));
                                                            let _e1245 = (bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u)));
                                                            if (_e163.member_2 == 0f) {
                                                                phi_1879_ = 0f;
                                                            } else {
                                                                let _e1275 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                let _e1278 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                let _e1281 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                let _e1283 = select(_e1281, _e1278, (_e1278 > _e1281));
                                                                let _e1287 = select(_e1281, _e1278, (_e1278 < _e1281));
                                                                let _e1291 = select(_e1278, _e1275, (_e1275 < _e1278));
                                                                let _e1293 = select(_e1278, _e1275, (_e1275 > _e1278));
                                                                let _e1295 = select(_e1281, _e1293, (_e1293 < _e1281));
                                                                phi_1879_ = bitcast<f32>((bitcast<u32>((_e163.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1283, _e1275, (_e1275 > _e1283)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1295, _e1291, (_e1291 > _e1295)))) ^ _e163.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1287, _e1275, (_e1275 < _e1287)))) ^ _e163.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1231 + _e1238) + _e1245))) ^ _e163.member_3[0]))) * 1.0000005f)) ^ _e163.member_3[0])))) ^ _e163.member_3[0]));
                                                            }
                                                            let _e1322 = phi_1879_;
                                                            phi_1897_ = (_e1092 || !(((((bitcast<f32>((bitcast<u32>((_e1178.x * _e1205)) ^ _e163.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1178.y * _e1206)) ^ _e163.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1178.z * _e1207)) ^ _e163.member_3[0]))) * f32(-(_e1091))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1178.x) & 2147483647u)) * _e1231)) ^ _e163.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1178.y) & 2147483647u)) * _e1238)) ^ _e163.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1178.z) & 2147483647u)) * _e1245)) ^ _e163.member_3[0]))))) ^ _e163.member_3[0])) + _e1322) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1336 = phi_1897_;
                                                        phi_1898_ = _e1336;
                                                    }
                                                    let _e1338 = phi_1898_;
                                                    if _e1338 {
                                                        if (_e1078.member < _e698.member.member) {
                                                            phi_1918_ = true;
                                                        } else {
                                                            if (_e1078.member == _e698.member.member) {
                                                                phi_1917_ = (_e1078.member_3 < _e698.member.member_3);
                                                            } else {
                                                                phi_1917_ = false;
                                                            }
                                                            let _e1348 = phi_1917_;
                                                            phi_1918_ = _e1348;
                                                        }
                                                        let _e1350 = phi_1918_;
                                                        if _e1350 {
                                                            phi_1924_ = type_51(_e1078, _e1078.member);
                                                        } else {
                                                            phi_1924_ = _e698;
                                                        }
                                                        let _e1353 = phi_1924_;
                                                        phi_1925_ = _e1353;
                                                    } else {
                                                        phi_1925_ = _e698;
                                                    }
                                                    let _e1355 = phi_1925_;
                                                    phi_1926_ = _e1355;
                                                } else {
                                                    phi_1926_ = _e698;
                                                }
                                                let _e1357 = phi_1926_;
                                                phi_821_ = _e1357;
                                            } else {
                                                phi_821_ = type_51();
                                            }
                                            let _e1359 = phi_821_;
                                            continue;
                                            continuing {
                                                phi_820_ = _e1359;
                                                phi_823_ = _e713;
                                                phi_2537_ = _e470;
                                                break if !(_e719);
                                            }
                                        }
                                        let _e1362 = phi_2537_;
                                        phi_2663_ = _e1362;
                                        if _e1362 {
                                            break;
                                        }
                                        phi_2667_ = _e1362;
                                        let _e1562 = local_3;
                                        phi_2379_ = _e1562;
                                        phi_2380_ = _e495;
                                        phi_2381_ = false;
                                        phi_2382_ = _e499;
                                    } else {
                                        if (_e495 >= _e75) {
                                            phi_1986_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e495 < _e75) {
                                            } else {
                                                phi_2663_ = true;
                                                break;
                                            }
                                            let _e509 = (_e288 % 3u);
                                            if (_e509 < 3u) {
                                            } else {
                                                phi_2663_ = true;
                                                break;
                                            }
                                            let _e515 = global_3.member[_e495].member[_e509];
                                            let _e521 = (_e287 % 3u);
                                            if (_e521 < 3u) {
                                            } else {
                                                phi_2663_ = true;
                                                break;
                                            }
                                            let _e527 = global_3.member[_e495].member[_e521];
                                            let _e533 = (_e289 % 3u);
                                            if (_e533 < 3u) {
                                            } else {
                                                phi_2663_ = true;
                                                break;
                                            }
                                            let _e539 = global_3.member[_e495].member[_e533];
                                            let _e549 = global_3.member[_e495].member_1;
                                            let _e553 = global_3.member[_e495].member_2;
                                            phi_1986_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e515[0], _e515[1], _e515[2], _e515[3]), vec4<f32>(_e527[0], _e527[1], _e527[2], _e527[3]), vec4<f32>(_e539[0], _e539[1], _e539[2], _e539[3])), _e549, _e553);
                                        }
                                        let _e556 = phi_1986_;
                                        let _e568 = ((_e556.member[0].x - _e339) * _e344);
                                        let _e569 = ((_e556.member[0].y - _e339) * _e344);
                                        let _e570 = ((_e556.member[0].z - _e340) * _e344);
                                        let _e571 = ((_e556.member[0].w - _e340) * _e344);
                                        let _e581 = ((_e556.member[1].x - _e375) * _e380);
                                        let _e582 = ((_e556.member[1].y - _e375) * _e380);
                                        let _e583 = ((_e556.member[1].z - _e376) * _e380);
                                        let _e584 = ((_e556.member[1].w - _e376) * _e380);
                                        let _e594 = ((_e556.member[2].x - _e411) * _e416);
                                        let _e595 = ((_e556.member[2].y - _e411) * _e416);
                                        let _e596 = ((_e556.member[2].z - _e412) * _e416);
                                        let _e597 = ((_e556.member[2].w - _e412) * _e416);
                                        let _e599 = select(_e596, _e594, (_e594 < _e596));
                                        let _e601 = select(_e597, _e595, (_e595 < _e597));
                                        let _e603 = select(_e596, _e594, (_e594 > _e596));
                                        let _e605 = select(_e597, _e595, (_e595 > _e597));
                                        let _e607 = select(_e570, _e568, (_e568 < _e570));
                                        let _e609 = select(_e571, _e569, (_e569 < _e571));
                                        let _e611 = select(_e583, _e581, (_e581 < _e583));
                                        let _e613 = select(_e584, _e582, (_e582 < _e584));
                                        let _e615 = select(_e611, _e607, (_e607 > _e611));
                                        let _e617 = select(_e613, _e609, (_e609 > _e613));
                                        let _e619 = select(_e599, _e615, (_e615 > _e599));
                                        let _e621 = select(_e601, _e617, (_e617 > _e601));
                                        let _e623 = select(_e570, _e568, (_e568 > _e570));
                                        let _e625 = select(_e571, _e569, (_e569 > _e571));
                                        let _e627 = select(_e583, _e581, (_e581 > _e583));
                                        let _e629 = select(_e584, _e582, (_e582 > _e584));
                                        let _e631 = select(_e627, _e623, (_e623 < _e627));
                                        let _e633 = select(_e629, _e625, (_e625 < _e629));
                                        let _e638 = -(_e599);
                                        let _e639 = -(_e601);
                                        let _e646 = (select(_e603, _e631, (_e631 < _e603)) + (select(_e638, _e603, (_e603 > _e638)) * 0.0000019073523f));
                                        let _e647 = (select(_e605, _e633, (_e633 < _e605)) + (select(_e639, _e605, (_e605 > _e639)) * 0.0000019073523f));
                                        let _e649 = select(_e462, _e619, (_e619 > _e462));
                                        let _e651 = select(_e462, _e621, (_e621 > _e462));
                                        let _e656 = (_e649 <= select(_e472.member_1, _e646, (_e646 < _e472.member_1)));
                                        let _e657 = (_e651 <= select(_e472.member_1, _e647, (_e647 < _e472.member_1)));
                                        let _e658 = (_e649 <= _e651);
                                        if _e656 {
                                            if _e657 {
                                                if _e658 {
                                                    phi_2330_ = _e556.member_2;
                                                } else {
                                                    phi_2330_ = _e556.member_1;
                                                }
                                                let _e662 = phi_2330_;
                                                let _e663 = (_e499 % 128u);
                                                let _e664 = (_e663 < 128u);
                                                if _e664 {
                                                } else {
                                                    phi_2663_ = true;
                                                    break;
                                                }
                                                local[_e663] = _e662;
                                                if _e664 {
                                                } else {
                                                    phi_2663_ = true;
                                                    break;
                                                }
                                                local_1[_e663] = select(_e651, _e649, (_e649 > _e651));
                                                if _e658 {
                                                    phi_2356_ = _e556.member_1;
                                                } else {
                                                    phi_2356_ = _e556.member_2;
                                                }
                                                let _e673 = phi_2356_;
                                                phi_2357_ = _e673;
                                                phi_2358_ = (_e499 + 1u);
                                            } else {
                                                phi_2357_ = u32();
                                                phi_2358_ = u32();
                                            }
                                            let _e675 = phi_2357_;
                                            let _e677 = phi_2358_;
                                            phi_2360_ = _e675;
                                            phi_2361_ = _e677;
                                            phi_2362_ = select(true, false, _e657);
                                        } else {
                                            phi_2360_ = u32();
                                            phi_2361_ = u32();
                                            phi_2362_ = true;
                                        }
                                        let _e680 = phi_2360_;
                                        let _e682 = phi_2361_;
                                        let _e684 = phi_2362_;
                                        if _e684 {
                                            if _e656 {
                                                phi_2371_ = _e556.member_1;
                                            } else {
                                                phi_2371_ = _e556.member_2;
                                            }
                                            let _e688 = phi_2371_;
                                            phi_2376_ = _e688;
                                            phi_2377_ = select(_e657, true, _e656);
                                        } else {
                                            phi_2376_ = _e680;
                                            phi_2377_ = _e497;
                                        }
                                        let _e691 = phi_2376_;
                                        let _e693 = phi_2377_;
                                        phi_2667_ = _e470;
                                        phi_2379_ = _e472;
                                        phi_2380_ = _e691;
                                        phi_2381_ = _e693;
                                        phi_2382_ = select(_e682, _e499, _e684);
                                    }
                                    let _e1364 = phi_2667_;
                                    let _e1366 = phi_2379_;
                                    let _e1368 = phi_2380_;
                                    let _e1370 = phi_2381_;
                                    let _e1372 = phi_2382_;
                                    phi_2666_ = _e1364;
                                    phi_2383_ = _e1366;
                                    phi_2384_ = _e1368;
                                    phi_2385_ = (_e476 - 1u);
                                    phi_2386_ = _e1370;
                                    phi_2387_ = _e1372;
                                } else {
                                    phi_2666_ = _e470;
                                    phi_2383_ = _e472;
                                    phi_2384_ = _e495;
                                    phi_2385_ = _e476;
                                    phi_2386_ = _e497;
                                    phi_2387_ = _e499;
                                }
                                let _e1374 = phi_2666_;
                                let _e1376 = phi_2383_;
                                let _e1378 = phi_2384_;
                                let _e1380 = phi_2385_;
                                let _e1382 = phi_2386_;
                                let _e1384 = phi_2387_;
                                phi_2665_ = _e1374;
                                phi_2388_ = _e1376;
                                phi_2389_ = _e1378;
                                phi_2390_ = _e1380;
                                phi_2391_ = _e1382;
                                phi_2392_ = _e1384;
                            } else {
                                phi_2665_ = _e470;
                                phi_2388_ = type_51();
                                phi_2389_ = u32();
                                phi_2390_ = u32();
                                phi_2391_ = bool();
                                phi_2392_ = u32();
                            }
                            let _e1386 = phi_2665_;
                            let _e1388 = phi_2388_;
                            let _e1390 = phi_2389_;
                            let _e1392 = phi_2390_;
                            let _e1394 = phi_2391_;
                            let _e1396 = phi_2392_;
                            phi_2664_ = _e1386;
                            phi_753_ = _e1388;
                            phi_756_ = _e1390;
                            phi_758_ = _e1392;
                            phi_760_ = _e1394;
                            phi_762_ = _e1396;
                            phi_2393_ = _e484;
                        } else {
                            phi_2664_ = _e470;
                            phi_753_ = type_51();
                            phi_756_ = u32();
                            phi_758_ = u32();
                            phi_760_ = bool();
                            phi_762_ = u32();
                            phi_2393_ = false;
                        }
                        let _e1398 = phi_2664_;
                        let _e1400 = phi_753_;
                        let _e1402 = phi_756_;
                        let _e1404 = phi_758_;
                        let _e1406 = phi_760_;
                        let _e1408 = phi_762_;
                        let _e1410 = phi_2393_;
                        continue;
                        continuing {
                            phi_2543_ = _e1398;
                            phi_752_ = _e1400;
                            phi_755_ = _e1402;
                            phi_757_ = _e1404;
                            phi_759_ = _e1406;
                            phi_761_ = _e1408;
                            phi_2663_ = _e1398;
                            break if !(_e1410);
                        }
                    }
                    let _e1413 = phi_2663_;
                    if _e1413 {
                        break;
                    }
                    let _e1415 = local_2;
                    if (_e1415.member.member_3 != 4294967295u) {
                        let _e1420 = (_e290 / 3i);
                        let _e1427 = bitcast<f32>((bitcast<u32>((_e1420 + 127i)) << bitcast<u32>(23i)));
                        let _e1435 = (((_e1415.member.member * _e1427) * _e1427) * bitcast<f32>((bitcast<u32>(((_e290 - (2i * _e1420)) + 127i)) << bitcast<u32>(23i))));
                        let _e1437 = select(340282350000000000000000000000000000000f, _e1435, (_e1435 < 340282350000000000000000000000000000000f));
                        phi_2445_ = type_28(select(-340282350000000000000000000000000000000f, _e1437, (_e1437 > -340282350000000000000000000000000000000f)), _e1415.member.member_1, _e1415.member.member_2, _e1415.member.member_3);
                    } else {
                        phi_2445_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1444 = phi_2445_;
                    if _e95 {
                    } else {
                        break;
                    }
                    global_8.member[_e93] = _e1444;
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e1448 = select(0u, 1u, (_e234 <= _e244));
                    if (_e1448 > 0u) {
                        let _e1450 = (1u < _e89);
                        if _e1450 {
                            if (0u < _e89) {
                            } else {
                                break;
                            }
                            let _e1454 = atomicAdd((&global_9.member[0u]), _e1448);
                            if ((_e1454 + _e1448) < _e1454) {
                                if _e1450 {
                                } else {
                                    break;
                                }
                                let _e1459 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1462 = select(0u, 1u, (_e1444.member_3 != 4294967295u));
                    if (_e1462 > 0u) {
                        let _e1464 = (3u < _e89);
                        if _e1464 {
                            if (2u < _e89) {
                            } else {
                                break;
                            }
                            let _e1468 = atomicAdd((&global_9.member[2u]), _e1462);
                            if ((_e1468 + _e1462) < _e1468) {
                                if _e1464 {
                                } else {
                                    break;
                                }
                                let _e1473 = atomicAdd((&global_9.member[3u]), 1u);
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
