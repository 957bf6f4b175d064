using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>
/// What the client has said and the drive has not done yet: commands that wait for a step's end, and the newest controls or indicators.
/// Those that came before a reset are void with it, those that came behind it wait until it is done.
/// </summary>
/// <param name="bridge">The bridge to the client.</param>
/// <param name="report">Receives a message for each fault of the client.</param>
internal sealed class ClientAgenda(IDrivingBridge bridge, Action<string> report)
{
    /// <summary>A client that sends faster than the ticks go does not keep a tick busy.</summary>
    private const int MaxMessagesPerTick = 300;

    private const int MaxCommandsWaiting = 256;
    private readonly Queue<ClientMessage> _commands = new();
    private ClientMessage? _newest;
    private int _resetsWaiting;

    /// <summary>Takes what has come over the bridge.</summary>
    /// <returns>Whether the client is gone, or another one speaks now; nothing of the one before is left.</returns>
    public bool Receive()
    {
        bool isClientGone = false;
        for (int taken = 0; taken < MaxMessagesPerTick && bridge.TryReceive(out ClientMessage? message); taken++)
        {
            if (message is ClientGoneMessage)
            {
                isClientGone = true;
                _commands.Clear();
                _newest = null;
                _resetsWaiting = 0;
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

    /// <summary>The command whose turn it is.</summary>
    public bool TryTakeCommand([NotNullWhen(true)] out ClientMessage? command)
    {
        command = _commands.Count > 0 ? _commands.Dequeue() : null;
        _resetsWaiting -= command is ResetMessage ? 1 : 0;
        return command is not null;
    }

    /// <summary>The newest controls or indicators that have not been taken; null when there are none, or a reset comes first.</summary>
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
    }
}
