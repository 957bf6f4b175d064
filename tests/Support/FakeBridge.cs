using System.Diagnostics.CodeAnalysis;
using Harvester.Driving.Bridge;
using Harvester.Sessions.Imaging;

namespace Harvester.TestSupport;

/// <summary>
/// A bridge in memory, to a client that is the test. It gives messages out as the real ones do: commands first, of controls the newest.
/// </summary>
internal sealed class FakeBridge : IDrivingBridge, IClientInbox, IFrameOutbox
{
    private readonly ClientInbox<FakeBridge> _inbox = new();

    public FakeBridge() => _inbox.Welcome(this);

    public string? Problem { get; set; }

    public string? Client => null;

    /// <summary>What was published, and the number of the state that the picture shows.</summary>
    public List<(BridgeState State, long Shown)> Frames { get; } = [];

    public void Say(params ClientMessage[] messages) => Assert.All(messages, message => Assert.True(_inbox.TryPut(this, message)));

    /// <summary>The client goes, and another comes.</summary>
    public void ReplaceClient()
    {
        _inbox.Leave(this);
        _inbox.Welcome(this);
    }

    public IClientInbox Inbox => this;

    public IFrameOutbox Outbox => this;

    public bool HasClientGone => _inbox.HasClientGone;

    /// <summary>Whether a frame would be sent at once.</summary>
    public bool IsFrameAwaited { get; set; } = true;

    /// <summary>Whether the client is replaced while the next frame is made.</summary>
    public bool IsReplacedBeforeNextFrame { get; set; }

    public bool Publish(BridgeState state, PixelBuffer picture)
    {
        if (IsReplacedBeforeNextFrame)
        {
            IsReplacedBeforeNextFrame = false;
            ReplaceClient();
        }

        if (!HasClientGone)
        {
            Frames.Add((state, FakeGame.StateOf(picture)));
        }

        return !HasClientGone;
    }

    /// <summary>What happens when all messages are taken.</summary>
    public Action WhenEmpty { get; set; } = static () => { };

    public bool TryReceive([NotNullWhen(true)] out ClientMessage? message)
    {
        if (_inbox.TryReceive(out message))
        {
            return true;
        }

        WhenEmpty();
        return false;
    }

    public void Dispose() { }
}
