using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Messages of a client that wait: commands in order; of controls and indicators only the newest. A reset voids controls and indicators
/// received before it. Not thread-safe.
/// </summary>
internal sealed class MessageQueue
{
    /// <summary>If a client sends commands faster than they are taken, the newest are dropped.</summary>
    private const int CommandCapacity = 256;

    private readonly Queue<ClientMessage> _commands = new();
    private ClientMessage? _newest;

    /// <summary>Whether commands wait.</summary>
    public bool HasCommands => _commands.Count > 0;

    /// <summary>Whether nothing waits.</summary>
    public bool IsEmpty => _commands.Count == 0 && _newest is null;

    /// <summary>Number of resets among the commands.</summary>
    public int Resets { get; private set; }

    /// <summary>Adds a message.</summary>
    /// <returns>False if a command was dropped because the queue is full.</returns>
    public bool TryAdd(ClientMessage message)
    {
        if (message is ControlsMessage or IndicatorsMessage)
        {
            _newest = message;
            return true;
        }

        if (_commands.Count >= CommandCapacity)
        {
            return false;
        }

        _commands.Enqueue(message);
        if (message is ResetMessage)
        {
            _newest = null;
            Resets++;
        }

        return true;
    }

    /// <summary>Takes the next command.</summary>
    public bool TryTakeCommand([NotNullWhen(true)] out ClientMessage? command)
    {
        command = _commands.Count > 0 ? _commands.Dequeue() : null;
        Resets -= command is ResetMessage ? 1 : 0;
        return command is not null;
    }

    /// <summary>Takes the newest controls or indicators; null if there are no new ones.</summary>
    public ClientMessage? TakeNewest()
    {
        ClientMessage? newest = _newest;
        _newest = null;
        return newest;
    }

    /// <summary>Removes all messages.</summary>
    public void Clear()
    {
        _commands.Clear();
        _newest = null;
        Resets = 0;
    }
}
