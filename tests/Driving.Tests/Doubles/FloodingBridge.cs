using System.Diagnostics.CodeAnalysis;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Tests.Doubles;

/// <summary>A bridge whose client sends faster than anyone can take.</summary>
internal sealed class FloodingBridge : IDrivingBridge, IClientInbox, IFrameOutbox
{
    public int Taken { get; private set; }

    public string? Problem => null;

    public string? Client => null;

    public IClientInbox Inbox => this;

    public IFrameOutbox Outbox => this;

    public bool HasClientGone => false;

    public bool IsFrameAwaited => true;

    public bool Publish(BridgeState state, PixelBuffer picture) => true;

    public bool TryReceive([NotNullWhen(true)] out ClientMessage? message)
    {
        message = Taken++ % 2 == 0 ? new RequestFrameMessage() : new ControlsMessage(new DrivingControls(0.5, 0.25, 0), null);
        return true;
    }

    public void Dispose() { }
}
