using System.Diagnostics.CodeAnalysis;
using Harvester.Driving.Bridge;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Imaging;

namespace Harvester.TestSupport;

/// <summary>Frames to send over a bridge.</summary>
internal static class Frames
{
    public static readonly ImageSize Size = new(28, 21);

    public static BridgeState State(long frame) =>
        new(frame, frame / 10.0, 12.5, new Vector3D(1, 2, 3), 90, LaneIndicators.Unknown, LaneIndicators.Unknown, true);

    public static PixelBuffer Picture(byte shade)
    {
        var picture = new PixelBuffer(Size);
        Array.Fill(picture.Bytes, shade);
        return picture;
    }

    /// <summary>Waits for something that another thread does; long enough for a busy machine.</summary>
    public static void Await(Func<bool> done, string what)
    {
        DateTime end = DateTime.UtcNow.AddSeconds(30);
        while (!done())
        {
            Assert.True(DateTime.UtcNow < end, $"Waited in vain: {what}");
            Thread.Sleep(2);
        }
    }

    public static bool Publish(this IDrivingBridge bridge, BridgeState state, PixelBuffer picture) => bridge.Outbox.Publish(state, picture);

    public static bool TryReceive(this IDrivingBridge bridge, [NotNullWhen(true)] out ClientMessage? message) =>
        bridge.Inbox.TryReceive(out message);

    public static ClientMessage AwaitMessage(IDrivingBridge bridge)
    {
        ClientMessage? message = null;
        Await(() => bridge.TryReceive(out message), $"a message; the bridge says: {bridge.Problem}");
        return message!;
    }

    /// <summary>The next message of a client; messages about earlier clients leaving are skipped.</summary>
    public static ClientMessage AwaitWord(IDrivingBridge bridge)
    {
        ClientMessage message = AwaitMessage(bridge);
        while (message is ClientGoneMessage)
        {
            message = AwaitMessage(bridge);
        }

        return message;
    }
}
