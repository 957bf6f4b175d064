using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>Messages of the client, until the game takes them. Calls never wait.</summary>
public interface IClientInbox
{
    /// <summary>Whether the next message is a <see cref="ClientGoneMessage"/>.</summary>
    bool HasClientGone { get; }

    /// <summary>
    /// Takes the next message of the client. Of controls and indicators only the newest is kept; commands come in order. When the client
    /// disconnects or is replaced, a <see cref="ClientGoneMessage"/> precedes any message of another client, and none of the earlier
    /// client's follows it.
    /// </summary>
    bool TryReceive([NotNullWhen(true)] out ClientMessage? message);
}
