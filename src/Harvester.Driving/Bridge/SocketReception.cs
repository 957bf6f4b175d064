using System;

namespace Harvester.Driving.Bridge;

/// <summary>
/// What the connections of a socket bridge share: the rules, who counts and who does not yet, what goes out, and who hears of trouble.
/// </summary>
/// <param name="Options">How long, and with what token, a connection is admitted.</param>
/// <param name="Inbox">What the client that counts has said.</param>
/// <param name="Pending">The connections that have yet to show the token.</param>
/// <param name="Outbox">The frame that waits to be sent.</param>
/// <param name="Report">Is told what a client does wrong, on any thread.</param>
internal sealed record SocketReception(
    SocketBridgeOptions Options, ClientInbox<BridgeClient> Inbox, PendingClients<BridgeClient> Pending, FrameOutbox Outbox,
        Action<string> Report);
