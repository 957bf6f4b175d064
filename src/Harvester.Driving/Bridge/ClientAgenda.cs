using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>
/// What the client has sent and the drive has not done yet: commands that wait for the end of a step, and the newest controls or
/// indicators. A reset voids those sent before it; those sent after it wait until it is done.
/// </summary>
/// <param name="bridge">The bridge to the client.</param>
/// <param name="canRestart">Whether the game can be restarted; a restart is refused otherwise.</param>
/// <param name="report">Receives a message for each fault of the client.</param>
internal sealed class ClientAgenda(IDrivingBridge bridge, bool canRestart, Action<string> report)
{
    /// <summary>Limits the work of a tick if a client sends faster than the game ticks.</summary>
    private const int MaxMessagesPerTick = 300;

    private readonly MessageQueue _messages = new();
    private bool _isRestartWaiting;

    /// <summary>Whether commands wait.</summary>
    public bool HasCommands => _messages.HasCommands;

    /// <summary>
    /// Takes the messages that the bridge has received, up to a restart: what comes after that is meant for the drive that follows.
    /// </summary>
    /// <returns>Whether the client has disconnected or been replaced; nothing of the earlier client is left then.</returns>
    public bool Receive()
    {
        bool isClientGone = false;
        for (
            int taken = 0;
            (!_isRestartWaiting || bridge.HasClientGone) && taken < MaxMessagesPerTick && bridge.TryReceive(out ClientMessage? message);
            taken++
        )
        {
            if (message is ClientGoneMessage)
            {
                isClientGone = true;
                _messages.Clear();
                _isRestartWaiting = false;
            }
            else
            {
                Add(message);
            }
        }

        return isClientGone;
    }

    /// <summary>Takes the next command that may run now.</summary>
    public bool TryTakeCommand([NotNullWhen(true)] out ClientMessage? command) => _messages.TryTakeCommand(out command);

    /// <summary>Takes the newest controls or indicators; null if there are no new ones, or if a reset comes first.</summary>
    public ClientMessage? TakeNewest() => _messages.Resets > 0 ? null : _messages.TakeNewest();

    private void Add(ClientMessage message)
    {
        if (message is RestartMessage && !canRestart)
        {
            report(BridgeProtocol.NoRestart);
            return;
        }

        if (!_messages.TryAdd(message))
        {
            report("the client sends commands faster than they can be executed; the newest are dropped.");
            return;
        }

        _isRestartWaiting |= message is RestartMessage;
    }
}
