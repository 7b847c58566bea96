//! The server: loopback only, a random token in every address, and nothing for pages of other origins.

use std::convert::Infallible;
use std::net::Ipv4Addr;
use std::sync::Arc;

use axum::Json;
use axum::Router;
use axum::body::Body;
use axum::extract::{DefaultBodyLimit, Path, Query, Request, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use futures_util::stream;
use serde::Deserialize;
use serde_json::{Value, json};
use tokio::net::TcpListener;
use tokio::sync::mpsc::channel;
use tokio::sync::mpsc::error::TrySendError;

use super::page;
use super::questions::{Answers, Controls, Edit, Look, Refusal};
use crate::contract::RoomId;
use crate::disk::to_hex;

/// Bytes of a question at most: a look or an edit has a few hundred.
const LARGEST_BODY: usize = 64 << 10;
/// Bytes of the token: nobody guesses 128 bits.
const TOKEN_BYTES: usize = 16;
/// Events that a slow page may lag behind.
const EVENTS: usize = 16;
/// The header that a page of another origin cannot send without asking first.
const OWN_HEADER: &str = "x-roomwright";

/// A server that listens and does not answer yet.
pub(crate) struct Server {
    listener: std::net::TcpListener,
    guard: Arc<Guard>,
}

/// What a question has to have.
struct Guard {
    token: String,
    /// The names by which the server may be called, against pages that make a name of theirs point to this machine.
    hosts: [String; 2],
    /// What the page may do.
    policy: HeaderValue,
}

impl Server {
    /// Listens on this machine; any free port for 0.
    ///
    /// # Errors
    /// If the port is taken, or the system has no random numbers.
    pub(crate) fn listen(port: u16) -> std::io::Result<Self> {
        let listener = std::net::TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        listener.set_nonblocking(true)?;
        let port = listener.local_addr()?.port();
        let mut token = [0_u8; TOKEN_BYTES];
        getrandom::fill(&mut token).map_err(|error| std::io::Error::other(error.to_string()))?;
        let hosts = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
        let policy = HeaderValue::from_str(&page::policy()).map_err(std::io::Error::other)?;
        Ok(Self { listener, guard: Arc::new(Guard { token: to_hex(&token), hosts, policy }) })
    }

    /// The address of the page.
    pub(crate) fn address(&self) -> String {
        format!("http://{}/{}/", self.guard.hosts[0], self.guard.token)
    }
}

/// Answers until the process ends.
///
/// # Errors
/// If the system refuses to go on listening.
pub(crate) fn serve(server: Server, answers: Arc<dyn Answers>) -> std::io::Result<()> {
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build()?;
    runtime.block_on(async move {
        let listener = TcpListener::from_std(server.listener)?;
        axum::serve(listener, router(answers, server.guard)).await
    })
}

fn router(answers: Arc<dyn Answers>, guard: Arc<Guard>) -> Router {
    // Routes are below the token: without it, nothing is there at all.
    let at = |path: &str| format!("/{}/{path}", guard.token);
    Router::new()
        .route(&at(""), get(|| async { file(page::index()) }))
        .route(&at("page/{*path}"), get(page_file))
        .route(&at("api/site"), get(site))
        .route(&at("api/level"), get(level))
        .route(&at("api/levelfile"), get(level_file))
        .route(&at("api/look"), post(look))
        .route(&at("api/room"), get(room))
        .route(&at("api/explain"), get(explain))
        .route(&at("api/edits"), get(edits))
        .route(&at("api/edit"), post(edit))
        .route(&at("api/reroll"), post(reroll))
        .route(&at("api/settings"), post(settings))
        .route(&at("api/events"), get(events))
        .route(&at("shared/{*path}"), get(shared))
        .with_state(answers)
        .layer(DefaultBodyLimit::max(LARGEST_BODY))
        .layer(from_fn_with_state(guard, guarded))
}

/// Refuses what does not come from the page of this server, and says to browsers what the page may do.
async fn guarded(State(guard): State<Arc<Guard>>, request: Request, next: Next) -> Response {
    let mut response = match refused(&guard, &request) {
        Some(why) => (StatusCode::FORBIDDEN, why).into_response(),
        None => next.run(request).await,
    };
    let headers = response.headers_mut();
    let mut set = |name: header::HeaderName, value: &'static str| {
        headers.entry(name).or_insert(HeaderValue::from_static(value));
    };
    set(header::X_CONTENT_TYPE_OPTIONS, "nosniff");
    set(header::REFERRER_POLICY, "no-referrer");
    set(header::CACHE_CONTROL, "no-store");
    set(header::X_FRAME_OPTIONS, "DENY");
    set(header::HeaderName::from_static("cross-origin-resource-policy"), "same-origin");
    set(header::HeaderName::from_static("cross-origin-opener-policy"), "same-origin");
    headers.insert(header::CONTENT_SECURITY_POLICY, guard.policy.clone());
    response
}

fn refused(guard: &Guard, request: &Request) -> Option<&'static str> {
    let headers = request.headers();
    let text = |name: header::HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    if !text(header::HOST).is_some_and(|host| guard.hosts.iter().any(|known| known == host)) {
        return Some("this server is asked by the name 127.0.0.1 or localhost only\n");
    }
    let is_own = |origin: &str| guard.hosts.iter().any(|host| origin == format!("http://{host}"));
    if headers.contains_key(header::ORIGIN) && !text(header::ORIGIN).is_some_and(is_own) {
        return Some("pages of other origins get no answer\n");
    }
    let is_question =
        request.method() == axum::http::Method::GET || request.method() == axum::http::Method::HEAD;
    if !is_question && !is_from_page(headers) {
        return Some("changes come from the page of this server\n");
    }
    None
}

fn is_from_page(headers: &HeaderMap) -> bool {
    headers.contains_key(OWN_HEADER)
}

/// The id of a building in an address.
#[derive(Deserialize)]
struct BuildingQuery {
    building: String,
}

/// The ids of a room in an address.
#[derive(Deserialize)]
struct RoomQuery {
    building: String,
    level: String,
    #[serde(default)]
    room: String,
    /// Part of the address only, so that a browser keeps each version.
    #[serde(default)]
    version: Option<String>,
}

impl RoomQuery {
    fn id(&self) -> RoomId {
        RoomId::new(&self.building, &self.level, &self.room)
    }
}

/// Runs work that takes a while beside the threads that answer.
async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, Refusal> + Send + 'static,
) -> Result<T, Refusal> {
    let done = tokio::task::spawn_blocking(work).await;
    done.unwrap_or_else(|_| Err(Refusal::Bad("the program has a fault: see where it was started".to_owned())))
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let (status, error) = self.told();
        let status = StatusCode::from_u16(status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
        (status, Json(json!({"error": error}))).into_response()
    }
}

type Answer<T> = Result<T, Refusal>;

fn file((bytes, media_type): (&'static [u8], &'static str)) -> Response {
    ([(header::CONTENT_TYPE, media_type)], bytes).into_response()
}

/// Bytes that never change under their address.
fn lasting(bytes: Vec<u8>, media_type: &'static str) -> Response {
    let headers =
        [(header::CONTENT_TYPE, media_type), (header::CACHE_CONTROL, "private, max-age=86400, immutable")];
    (headers, Body::from(bytes)).into_response()
}

async fn page_file(Path(path): Path<String>) -> Answer<Response> {
    page::file(&path).map(file).ok_or_else(|| Refusal::NotFound(format!("the page has no file {path}")))
}

async fn site(State(answers): State<Arc<dyn Answers>>) -> Answer<Json<Value>> {
    blocking(move || Ok(answers.site())).await.map(Json)
}

async fn level(
    State(answers): State<Arc<dyn Answers>>,
    Query(query): Query<RoomQuery>,
) -> Answer<Json<Value>> {
    blocking(move || answers.level(&query.building, &query.level)).await.map(Json)
}

async fn look(State(answers): State<Arc<dyn Answers>>, Json(look): Json<Look>) -> Answer<Response> {
    blocking(move || answers.look(&look)).await.map(|answer| Json(answer).into_response())
}

async fn room(State(answers): State<Arc<dyn Answers>>, Query(query): Query<RoomQuery>) -> Answer<Response> {
    let has_version = query.version.is_some();
    let bytes = blocking(move || answers.room(&query.id())).await?;
    let media_type = "model/gltf-binary";
    Ok(if has_version {
        lasting(bytes, media_type)
    } else {
        ([(header::CONTENT_TYPE, media_type)], Body::from(bytes)).into_response()
    })
}

async fn level_file(
    State(answers): State<Arc<dyn Answers>>,
    Query(query): Query<RoomQuery>,
) -> Answer<Response> {
    let bytes = blocking(move || answers.level_file(&query.building, &query.level)).await?;
    Ok(([(header::CONTENT_TYPE, "model/gltf-binary")], Body::from(bytes)).into_response())
}

async fn shared(State(answers): State<Arc<dyn Answers>>, Path(path): Path<String>) -> Answer<Response> {
    let media_type = if path.ends_with(".png") { "image/png" } else { "application/octet-stream" };
    blocking(move || answers.shared(&path)).await.map(|bytes| lasting(bytes.to_vec(), media_type))
}

async fn explain(
    State(answers): State<Arc<dyn Answers>>,
    Query(query): Query<RoomQuery>,
) -> Answer<Json<Value>> {
    blocking(move || answers.explain(&query.id())).await.map(Json)
}

async fn edits(
    State(answers): State<Arc<dyn Answers>>,
    Query(query): Query<BuildingQuery>,
) -> Answer<Json<Value>> {
    blocking(move || Ok(answers.edits(&query.building))).await.map(Json)
}

async fn edit(State(answers): State<Arc<dyn Answers>>, Json(edit): Json<Edit>) -> Answer<Json<Value>> {
    blocking(move || answers.edit(&edit)).await.map(Json)
}

async fn reroll(
    State(answers): State<Arc<dyn Answers>>,
    Json(query): Json<RoomQuery>,
) -> Answer<Json<Value>> {
    blocking(move || answers.reroll(&query.id())).await.map(Json)
}

async fn settings(
    State(answers): State<Arc<dyn Answers>>,
    Json(controls): Json<Controls>,
) -> Answer<Json<Value>> {
    blocking(move || answers.set_controls(controls)).await.map(Json)
}

/// Tells the page what changes, for as long as it listens.
async fn events(State(answers): State<Arc<dyn Answers>>) -> impl IntoResponse {
    let (sender, receiver) = channel::<String>(EVENTS);
    answers.listen(Box::new(move |event| {
        // A page that has events to read asks for everything anew anyway.
        !matches!(sender.try_send(event.to_owned()), Err(TrySendError::Closed(_)))
    }));
    let events = stream::unfold(receiver, |mut receiver| async {
        let text = receiver.recv().await?;
        Some((Ok::<Event, Infallible>(Event::default().data(text)), receiver))
    });
    Sse::new(events).keep_alive(KeepAlive::default())
}
