namespace Harvester.Driving.Bridge;

/// <summary>
/// What the connections of a socket bridge share: options, the current and the pending clients, outgoing frames, and error reports.
/// </summary>
/// <param name="Options">How long, and with what token, a connection is admitted.</param>
/// <param name="Inbox">Messages of the current client.</param>
/// <param name="Pending">The connections that have not sent a valid hello yet.</param>
/// <param name="Outbox">The frame that waits to be sent.</param>
/// <param name="Report">Receives a message for each error of a client, on any thread.</param>
internal sealed record SocketReception(
    SocketBridgeOptions Options,
    ClientInbox<BridgeClient> Inbox,
    PendingClients<BridgeClient> Pending,
    FrameOutbox<BridgeClient> Outbox,
    Action<string> Report
);
