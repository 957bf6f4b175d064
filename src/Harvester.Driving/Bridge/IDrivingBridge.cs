namespace Harvester.Driving.Bridge;

/// <summary>
/// The game's end of a bridge to a client that drives. Calls come from the game's thread and never wait for a disk, a network or a client.
/// An error of a client is never thrown here; it is reported in <see cref="Problem"/>.
/// </summary>
public interface IDrivingBridge : IDisposable
{
    /// <summary>The last problem, as one line; null if there was none.</summary>
    string? Problem { get; }

    /// <summary>The current client, for display: the address of a socket or the folder; null if there is none.</summary>
    string? Client { get; }

    /// <summary>Messages of the client.</summary>
    IClientInbox Inbox { get; }

    /// <summary>Frames for the client.</summary>
    IFrameOutbox Outbox { get; }
}
