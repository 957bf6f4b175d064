using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Bridge;

/// <summary>The newest frame, until the client is sent it. Calls never wait.</summary>
public interface IFrameOutbox
{
    /// <summary>Whether a frame that is offered now is sent at once: none waits, and the client has answered the last one.</summary>
    bool IsFrameAwaited { get; }

    /// <summary>
    /// Offers a frame. A frame that the client has not been sent yet is replaced. While <see cref="IClientInbox.HasClientGone"/> is true,
    /// the frame is dropped: it was made for a client that is gone.
    /// </summary>
    /// <param name="state">Car, time and indicators of the frame.</param>
    /// <param name="picture">The image; it is copied, so the caller may reuse it at once.</param>
    /// <returns>Whether the frame was taken.</returns>
    bool Publish(BridgeState state, PixelBuffer picture);
}
