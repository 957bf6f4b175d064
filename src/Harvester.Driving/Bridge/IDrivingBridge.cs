using System;
using System.Diagnostics.CodeAnalysis;
using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The game's end of a bridge to whoever drives. Both calls come from the game's thread and never wait: for a disk, a network or a
/// client. What a client does wrong is never thrown here; it is in <see cref="Problem"/>.
/// </summary>
public interface IDrivingBridge : IDisposable
{
    /// <summary>The last thing that went wrong, as one line; null when nothing has.</summary>
    string? Problem { get; }

    /// <summary>The connected client, for display: the address of a socket or the folder; null for none.</summary>
    string? Client { get; }

    /// <summary>Offers a frame. The newest wins: one that the client has not been given yet is dropped for it.</summary>
    /// <param name="state">Car, time and indicators of the frame.</param>
    /// <param name="picture">The image; it is copied, so the caller may reuse it at once.</param>
    void Publish(BridgeState state, PixelBuffer picture);

    /// <summary>
    /// The next message of the client. Of controls and indicators only the newest is kept; commands come in their order. When the client is
    /// gone or replaced a <see cref="ClientGoneMessage"/> comes before anything that another says, and nothing of the earlier one's after
    /// it.
    /// </summary>
    bool TryReceive([NotNullWhen(true)] out ClientMessage? message);
}
