//! Services that make models, against a scripted server on loopback. It speaks for them: no test needs a network or a key
//! that is worth anything.
#![cfg(feature = "services")]

use crate::generating::{ask, bounds, query};
use crate::made::block;
use scenelang_catalogue::Why;
use scenelang_catalogue::generator::{Generator, Service, ServiceKind};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tempfile::tempdir;

/// Status and body by method and path; `{url}` is where the server is.
type Script = fn(&str) -> (u16, Vec<u8>);

/// What was asked: "POST /path body".
type Asked = Arc<Mutex<Vec<String>>>;

fn server(script: Script) -> (String, Asked) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let url = format!("http://{}", listener.local_addr().unwrap());
    let asked: Asked = Arc::default();
    let (memory, base) = (Arc::clone(&asked), url.clone());
    std::thread::spawn(move || {
        for stream in listener.incoming() {
            let Ok(mut stream) = stream else { return };
            let Some((line, body)) = read(&mut stream) else { continue };
            let (status, answer) = script(&line);
            memory.lock().unwrap().push(format!("{line} {body}"));
            let answer = match String::from_utf8(answer) {
                Ok(text) => text.replace("{url}", &base).into_bytes(),
                Err(bytes) => bytes.into_bytes(),
            };
            let head = format!("HTTP/1.1 {status} X\r\ncontent-length: {}\r\nconnection: close\r\n\r\n", answer.len());
            let _ = stream.write_all(&[head.as_bytes(), &answer].concat());
        }
    });
    (url, asked)
}

/// The method with the path, and the body.
fn read(stream: &mut TcpStream) -> Option<(String, String)> {
    stream.set_read_timeout(Some(Duration::from_secs(10))).ok()?;
    let (mut bytes, mut buffer) = (Vec::new(), [0; 4096]);
    let head = loop {
        if let Some(end) = bytes.windows(4).position(|w| w == b"\r\n\r\n") {
            break end + 4;
        }
        match stream.read(&mut buffer).ok()? {
            0 => return None,
            n => bytes.extend_from_slice(&buffer[..n]),
        }
    };
    let text = String::from_utf8_lossy(&bytes[..head]).to_lowercase();
    let length = text.lines().find_map(|l| l.strip_prefix("content-length: ")?.trim().parse::<usize>().ok());
    while bytes.len() < head + length.unwrap_or(0) {
        match stream.read(&mut buffer).ok()? {
            0 => return None,
            n => bytes.extend_from_slice(&buffer[..n]),
        }
    }
    let line = String::from_utf8_lossy(&bytes[..head]).lines().next()?.rsplit_once(' ')?.0.to_owned();
    Some((line, String::from_utf8_lossy(&bytes[head..]).into_owned()))
}

fn json(status: u16, body: &Value) -> (u16, Vec<u8>) {
    (status, body.to_string().into_bytes())
}

fn chair() -> Vec<u8> {
    block(1.0, 2.0, 1.0).glb()
}

/// The size of what was made, or why nothing was.
type Outcome = Result<[f64; 3], (Why, String)>;

/// What came of an order of a chair: the size, or why not; and what was asked for that.
fn ordered(kind: ServiceKind, script: Script) -> (Outcome, Vec<String>) {
    let (mut url, asked) = server(script);
    if kind == ServiceKind::Gradio {
        url += "/generate";
    }
    let kept = tempdir().unwrap();
    let service = Service::on(kind, &url, "test-key", Duration::from_secs(10), || false).unwrap();
    let generator = Generator::new(Box::new(service), bounds(kept.path(), 9));
    let mut reply = ask(&generator, &[query("chair", [0.5, 0.9, 0.5])]).remove(0);
    let got = match reply.given {
        Some(given) => Ok(given.piece.size.into()),
        None => Err((reply.remarks[0].why, reply.remarks.remove(0).say)),
    };
    let asked = asked.lock().unwrap().clone();
    (got, asked)
}

#[test]
fn a_server_answers_with_the_file() {
    let (got, asked) = ordered(ServiceKind::Hunyuan, |line| match line {
        "POST /generate" => (200, chair()),
        _ => (404, Vec::new()),
    });
    assert_eq!(got, Ok([0.5, 0.9, 0.5]), "{asked:?}");
    assert!(asked.len() == 1 && asked[0].contains("\"text\":\"red chair\""), "{asked:?}");
}

#[test]
fn a_task_is_looked_at_until_it_is_done() {
    let (got, asked) = ordered(ServiceKind::Meshy, |line| match line {
        "POST /openapi/v2/text-to-3d" => json(202, &json!({ "result": "task-1" })),
        "GET /openapi/v2/text-to-3d/task-1" => {
            json(200, &json!({ "status": "SUCCEEDED", "progress": 100, "model_urls": { "glb": "{url}/files/a.glb" } }))
        }
        "GET /files/a.glb" => (200, chair()),
        _ => (404, Vec::new()),
    });
    assert_eq!(got, Ok([0.5, 0.9, 0.5]), "{asked:?}");
    assert_eq!(asked.len(), 3, "{asked:?}");
    let (got, asked) = ordered(ServiceKind::Tripo, |line| match line {
        "POST /v2/openapi/task" => json(200, &json!({ "code": 0, "data": { "task_id": "t" } })),
        "GET /v2/openapi/task/t" => {
            json(200, &json!({ "data": { "status": "success", "output": { "model": "{url}/m.glb" } } }))
        }
        "GET /m.glb" => (200, chair()),
        _ => (404, Vec::new()),
    });
    assert_eq!(got, Ok([0.5, 0.9, 0.5]), "{asked:?}");
}

fn app() -> (u16, Vec<u8>) {
    app_of("generate")
}

/// What an app says of its function `generate`, which has the inputs of one of three.
fn app_of(function: &str) -> (u16, Vec<u8>) {
    let input = |name: &str, kind: &str, default: Value| {
        json!({ "parameter_name": name, "parameter_has_default": !default.is_null(), "parameter_default": default,
                "type": { "type": kind } })
    };
    let inputs = match function {
        "generate" => vec![
            input("seed", "number", json!(7)),
            input("prompt", "string", json!("")),
            input("style", "string", json!("plain")),
        ],
        "draw" => vec![input("prompt", "string", Value::Null), input("image", "object", Value::Null)],
        _ => Vec::new(),
    };
    let named = json!({ "/generate": { "parameters": inputs } });
    json(200, &json!({ "named_endpoints": named }))
}

#[test]
fn a_function_of_an_app_is_called() {
    let (got, asked) = ordered(ServiceKind::Gradio, |line| match line {
        "GET /gradio_api/info" => app(),
        "POST /gradio_api/call/generate" => json(200, &json!({ "event_id": "e1" })),
        "GET /gradio_api/call/generate/e1" => {
            let result = r#"[null, {"value": {"path": "/tmp/a.GLB", "url": "{url}/gradio_api/file=/tmp/a.glb"}}]"#;
            (200, format!("event: heartbeat\ndata: null\n\nevent: complete\ndata: {result}\n\n").into_bytes())
        }
        "GET /gradio_api/file=/tmp/a.glb" => (200, chair()),
        _ => (404, Vec::new()),
    });
    assert_eq!(got, Ok([0.5, 0.9, 0.5]), "{asked:?}");
    assert!(asked[1].ends_with(r#"{"data":[7,"red chair","plain"]}"#), "{asked:?}");
    // Version 4 has its addresses at the root, and this one gives only the path of the file.
    let (got, asked) = ordered(ServiceKind::Gradio, |line| match line {
        "GET /info" => app(),
        "POST /call/generate" => json(200, &json!({ "event_id": "e1" })),
        "GET /call/generate/e1" => (200, b"event: complete\ndata: [{\"path\": \"/tmp/a.glb\"}]\n\n".to_vec()),
        "GET /file=/tmp/a.glb" => (200, chair()),
        _ => (404, Vec::new()),
    });
    assert_eq!(got, Ok([0.5, 0.9, 0.5]), "{asked:?}");
}

#[test]
fn each_way_in_which_an_app_fails_is_told() {
    let rows: [(Script, &str); 7] = [
        (|_| (404, Vec::new()), "there is no Gradio app at this address"),
        (
            |line| match line {
                "GET /gradio_api/info" => json(200, &json!({ "named_endpoints": { "/a": {}, "/b": {} } })),
                _ => (404, Vec::new()),
            },
            "the app has no function `generate`; it has: a, b",
        ),
        (
            |line| match line {
                "GET /gradio_api/info" => app_of("look"),
                _ => (404, Vec::new()),
            },
            "the function `generate` has no input for a text",
        ),
        (
            |line| match line {
                "GET /gradio_api/info" => app_of("draw"),
                _ => (404, Vec::new()),
            },
            "the input `image` of the function `generate` has no default",
        ),
        (
            |line| match line {
                "GET /gradio_api/info" => app(),
                "POST /gradio_api/call/generate" => json(200, &json!({ "event_id": "../../x" })),
                _ => (404, Vec::new()),
            },
            "did not name a task",
        ),
        (
            |line| match line {
                "GET /gradio_api/info" => app(),
                "POST /gradio_api/call/generate" => json(200, &json!({ "event_id": "e" })),
                _ => (200, b"event: error\ndata: \"no memory\"\n\n".to_vec()),
            },
            "the app could not make it: \"no memory\"",
        ),
        (
            |line| match line {
                "GET /gradio_api/info" => app(),
                "POST /gradio_api/call/generate" => json(200, &json!({ "event_id": "e" })),
                _ => (200, b"event: complete\ndata: [{\"path\": \"/tmp/a.png\"}]\n\n".to_vec()),
            },
            "the app returned no GLB file",
        ),
    ];
    for (script, said) in rows {
        let (got, asked) = ordered(ServiceKind::Gradio, script);
        let (why, message) = got.unwrap_err();
        assert!(why == Why::Failed && message.contains(said), "{said}: {message} {asked:?}");
    }
    let at = |url: &str| Service::on(ServiceKind::Gradio, url, "", Duration::from_secs(1), || false).map(drop);
    for url in ["http://127.0.0.1:7860", "http://127.0.0.1:7860/a b", "generate", ""] {
        assert!(at(url).unwrap_err().starts_with("gradio needs the address of an app"), "{url}");
    }
}

#[test]
fn each_way_in_which_a_service_fails_is_told() {
    let rows: [(ServiceKind, Script, Why, &str); 8] = [
        (
            ServiceKind::Hunyuan,
            |_| json(500, &json!({ "error": "no memory" })),
            Why::Failed,
            "reports an internal error (500): no memory",
        ),
        (ServiceKind::Hunyuan, |_| (200, b"<html>".to_vec()), Why::Broken, "it is not a GLB file"),
        (
            ServiceKind::Meshy,
            |_| json(401, &json!({ "message": "who?" })),
            Why::Failed,
            "does not accept the key: who?",
        ),
        (ServiceKind::Meshy, |_| (302, Vec::new()), Why::Failed, "it redirects to another host"),
        (ServiceKind::Meshy, |_| json(200, &json!({ "result": "../../etc" })), Why::Failed, "did not name a task"),
        (
            ServiceKind::Meshy,
            |line| match line {
                "POST /openapi/v2/text-to-3d" => json(200, &json!({ "result": "a" })),
                _ => json(200, &json!({ "status": "FAILED", "task_error": { "message": "too\u{1b}[31m rude" } })),
            },
            Why::Failed,
            "could not make it: too [31m rude",
        ),
        (
            ServiceKind::Tripo,
            |line| match line {
                "POST /v2/openapi/task" => json(200, &json!({ "data": { "task_id": "t" } })),
                _ => json(200, &json!({ "data": { "status": "success", "output": { "model": "http://10.0.0.1/x" } } })),
            },
            Why::Failed,
            "at an address that is not https",
        ),
        (
            ServiceKind::Tripo,
            |line| match line {
                "POST /v2/openapi/task" => json(200, &json!({ "data": { "task_id": "t" } })),
                _ => {
                    json(200, &json!({ "data": { "status": "success", "output": { "model": "https://localhost/x" } } }))
                }
            },
            Why::Failed,
            "it names a file on this machine",
        ),
    ];
    for (kind, script, why, say) in rows {
        let (got, asked) = ordered(kind, script);
        let got = got.unwrap_err();
        assert!(got.0 == why && got.1.contains(say), "{say}: {got:?} {asked:?}");
    }
}

#[test]
fn a_key_is_needed_and_stays_private() {
    let at = |url: &str| Service::on(ServiceKind::Meshy, url, "k", Duration::from_secs(1), || false).map(drop);
    assert!(at("http://a.example").unwrap_err().contains("must start with https"));
    assert!(at("ftp://a.example").unwrap_err().contains("must start with https:// or http://"));
    let none = Service::on(ServiceKind::Meshy, "https://a.example", "", Duration::from_secs(1), || false);
    assert_eq!(none.map(drop), Err("meshy needs a key: set MESHY_API_KEY".to_owned()));
}
