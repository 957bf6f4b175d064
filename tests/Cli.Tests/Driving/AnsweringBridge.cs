using System.Diagnostics.CodeAnalysis;
using Harvester.Driving.Bridge;
using Harvester.Sessions.Imaging;

namespace Harvester.Cli.Tests.Driving;

/// <summary>A bridge within the process to a client that answers each frame at once.</summary>
/// <param name="answer">What it says to a frame.</param>
/// <param name="first">What it says before the first.</param>
internal sealed class AnsweringBridge(Func<BridgeState, IEnumerable<ClientMessage>> answer, params ClientMessage[] first)
    : IDrivingBridge,
        IClientInbox,
        IFrameOutbox
{
    private readonly Queue<ClientMessage> _messages = new(first);

    public string? Problem => null;

    public string? Client => "the test";

    public IClientInbox Inbox => this;

    public IFrameOutbox Outbox => this;

    public bool HasClientGone => false;

    public bool IsFrameAwaited => _messages.Count == 0;

    public bool Publish(BridgeState state, PixelBuffer picture)
    {
        foreach (ClientMessage message in answer(state))
        {
            _messages.Enqueue(message);
        }

        return true;
    }

    public bool TryReceive([NotNullWhen(true)] out ClientMessage? message) => _messages.TryDequeue(out message);

    public void Dispose() { }
}
