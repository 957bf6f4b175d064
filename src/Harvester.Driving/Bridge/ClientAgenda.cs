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

    private const int MaxCommandsWaiting = 256;
    private readonly Queue<ClientMessage> _commands = new();
    private ClientMessage? _newest;
    private int _resetsWaiting;
    private bool _isRestartWaiting;

    /// <summary>Whether commands wait.</summary>
    public bool HasCommands => _commands.Count > 0;

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
                _commands.Clear();
                _newest = null;
                _resetsWaiting = 0;
                _isRestartWaiting = false;
            }
            else if (message is ControlsMessage or IndicatorsMessage)
            {
                _newest = message;
            }
            else
            {
                Add(message);
            }
        }

        return isClientGone;
    }

    /// <summary>Takes the next command that may run now.</summary>
    public bool TryTakeCommand([NotNullWhen(true)] out ClientMessage? command)
    {
        command = _commands.Count > 0 ? _commands.Dequeue() : null;
        _resetsWaiting -= command is ResetMessage ? 1 : 0;
        return command is not null;
    }

    /// <summary>Takes the newest controls or indicators; null if there are no new ones, or if a reset comes first.</summary>
    public ClientMessage? TakeNewest()
    {
        if (_resetsWaiting > 0)
        {
            return null;
        }

        ClientMessage? newest = _newest;
        _newest = null;
        return newest;
    }

    private void Add(ClientMessage command)
    {
        if (command is RestartMessage && !canRestart)
        {
            report(BridgeProtocol.NoRestart);
            return;
        }

        if (_commands.Count >= MaxCommandsWaiting)
        {
            report("the client sends commands faster than they can be executed; the newest are dropped.");
            return;
        }

        _commands.Enqueue(command);
        if (command is ResetMessage)
        {
            _newest = null;
            _resetsWaiting++;
        }

        _isRestartWaiting |= command is RestartMessage;
    }
}
