using System.Diagnostics.CodeAnalysis;
using Harvester.Sessions.Imaging;

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

    /// <summary>Whether the next message is a <see cref="ClientGoneMessage"/>.</summary>
    bool HasClientGone { get; }

    /// <summary>Whether a frame that is offered now is sent at once: none waits, and the client has answered the last one.</summary>
    bool IsFrameAwaited { get; }

    /// <summary>
    /// Offers a frame. A frame that the client has not been sent yet is replaced. While <see cref="HasClientGone"/> is true, the frame is
    /// dropped: it was made for a client that is gone.
    /// </summary>
    /// <param name="state">Car, time and indicators of the frame.</param>
    /// <param name="picture">The image; it is copied, so the caller may reuse it at once.</param>
    /// <returns>Whether the frame was taken.</returns>
    bool Publish(BridgeState state, PixelBuffer picture);

    /// <summary>
    /// Takes the next message of the client. Of controls and indicators only the newest is kept; commands come in order. When the client
    /// disconnects or is replaced, a <see cref="ClientGoneMessage"/> precedes any message of another client, and none of the earlier
    /// client's follows it.
    /// </summary>
    bool TryReceive([NotNullWhen(true)] out ClientMessage? message);
}
