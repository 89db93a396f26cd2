//! A browser takes every module, as WGSL that wgpu makes of it at run time. Browsers refuse more than naga does.

use super::contract::wgsl;
use serde_json::{Map, Value, json};
use slimbvh::gpu::{self, Kernel};
use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::channel;
use std::time::Duration;

/// Makes a shader module of each text, and sends what the browser says of it: an empty text where it takes it.
const PAGE: &str = "<script type=module>
const send = (answer) => fetch('/answer', {method: 'POST', body: JSON.stringify(answer)});
try {
    const texts = await (await fetch('/texts')).json();
    const device = await (await navigator.gpu.requestAdapter()).requestDevice();
    const answer = {};
    for (const name in texts) {
        const module = device.createShaderModule({code: texts[name]});
        const {messages} = await module.getCompilationInfo();
        answer[name] = messages.filter((m) => m.type == 'error').map((m) => m.message).join('; ');
    }
    await send(answer);
} catch (error) {
    await send(`${error}`);
}
</script>";

/// How long a browser may take to start and to read all texts.
const PATIENCE: Duration = Duration::from_secs(300);

/// A running browser, ended when it is dropped.
struct Browser(Child);

impl Drop for Browser {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A browser with a software GPU, at a page of this machine.
fn start(browser: &OsString, profile: &std::path::Path, port: u16) -> std::io::Result<Browser> {
    let mut command = Command::new(browser);
    command.args([
        "--headless",
        "--no-sandbox",
        "--enable-unsafe-webgpu",
        "--use-webgpu-adapter=swiftshader",
        "--enable-features=Vulkan",
        // Keeps the headless browser open while the page works.
        "--remote-debugging-port=0",
    ]);
    let mut folder = OsString::from("--user-data-dir=");
    folder.push(profile);
    command.arg(folder).arg(format!("http://127.0.0.1:{port}/"));
    let silent = command.stdout(Stdio::null()).stderr(Stdio::null());
    silent.spawn().map(Browser)
}

/// Answers one request. Returns the body of a posted one.
fn serve(mut stream: TcpStream, texts: &str) -> std::io::Result<Option<String>> {
    let mut reader = BufReader::new(stream.try_clone()?);
    let (mut request, mut length) = (String::new(), 0);
    reader.read_line(&mut request)?;
    loop {
        let mut line = String::new();
        reader.read_line(&mut line)?;
        let line = line.trim().to_lowercase();
        if line.is_empty() {
            break;
        }
        if let Some(number) = line.strip_prefix("content-length:") {
            length = number.trim().parse().unwrap_or(0);
        }
    }
    let mut body = vec![0; length];
    reader.read_exact(&mut body)?;
    let (kind, reply) = if request.starts_with("GET /texts ") {
        ("application/json", texts)
    } else if request.starts_with("GET / ") {
        ("text/html", PAGE)
    } else {
        ("text/plain", "")
    };
    let count = reply.len();
    write!(
        stream,
        "HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\nContent-Length: {count}\r\nConnection: close\r\n\r\n{reply}"
    )?;
    Ok(request
        .starts_with("POST ")
        .then(|| String::from_utf8_lossy(&body).into_owned()))
}

/// What a browser says of each text.
fn asked(browser: &OsString, texts: &Map<String, Value>) -> Map<String, Value> {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port of this machine is free");
    let port = listener.local_addr().expect("it has an address").port();
    let texts = Value::Object(texts.clone()).to_string();
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            if let Ok(Some(answer)) = serve(stream, &texts) {
                return sender.send(answer);
            }
        }
        Ok(())
    });
    let profile = tempfile::tempdir().expect("there is a folder for temporary files");
    let _browser = start(browser, profile.path(), port).expect("the browser starts");
    let answer = receiver
        .recv_timeout(PATIENCE)
        .expect("the browser answers");
    match serde_json::from_str(&answer) {
        Ok(Value::Object(answer)) => answer,
        _ => panic!("the browser has no WebGPU: {answer}"),
    }
}

/// The name of a text that browsers refuse.
const PLANTED: &str = "a planted number beyond f32";

#[test]
#[ignore = "needs a Chromium, whose path CHROMIUM names"]
fn chromium_takes_every_module() {
    let browser = std::env::var_os("CHROMIUM").expect("CHROMIUM names a Chromium");
    let mut texts: Map<String, Value> = Kernel::ALL
        .iter()
        .map(|&kernel| (kernel.name().to_owned(), json!(wgsl(kernel))))
        .collect();
    for (name, text) in [
        ("slimbvh.wgsl", gpu::wgsl(0)),
        ("slimbvh_compute.wgsl", gpu::wgsl_compute(0)),
    ] {
        texts.insert(name.to_owned(), json!(text));
    }
    let count = texts.len();
    // The negative control: what naga writes of the largest f32 is above it.
    let beyond = format!("const beyond = {}f;", f32::MAX);
    texts.insert(PLANTED.to_owned(), json!(beyond));

    let mut refused = asked(&browser, &texts);
    assert_eq!(refused.len(), count + 1, "each text has an answer");
    refused.retain(|_, why| why != "");
    assert!(
        refused.remove(PLANTED).is_some(),
        "it takes what it must refuse"
    );
    assert!(refused.is_empty(), "refused: {refused:#?}");
}
