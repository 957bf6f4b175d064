using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>
/// What the peer has said and the drive has not done yet: commands that wait for a step's end, and the newest controls or indicators. Those
/// that came before a reset are void with it, those that came behind it wait until it is done.
/// </summary>
/// <param name="bridge">To the peer.</param>
/// <param name="report">Is told what the peer does wrong.</param>
internal sealed class PeerAgenda(IDrivingBridge bridge, Action<string> report)
{
    /// <summary>A peer that sends faster than the ticks go does not keep a tick busy.</summary>
    private const int MostMessagesATick = 300;

    private const int MostCommandsWaiting = 256;
    private readonly Queue<PeerMessage> _commands = new();
    private PeerMessage? _newest;
    private int _resetsWaiting;

    /// <summary>Takes what has come over the bridge.</summary>
    /// <returns>Whether the peer is gone, or another one speaks now; nothing of the one before is left.</returns>
    public bool Receive()
    {
        bool isPeerGone = false;
        for (int taken = 0; taken < MostMessagesATick && bridge.TryReceive(out PeerMessage? message); taken++)
        {
            if (message is PeerGoneMessage)
            {
                isPeerGone = true;
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

        return isPeerGone;
    }

    /// <summary>The command whose turn it is.</summary>
    public bool TryTakeCommand([NotNullWhen(true)] out PeerMessage? command)
    {
        command = _commands.Count > 0 ? _commands.Dequeue() : null;
        _resetsWaiting -= command is ResetMessage ? 1 : 0;
        return command is not null;
    }

    /// <summary>The newest controls or indicators that have not been taken; null when there are none, or a reset comes first.</summary>
    public PeerMessage? TakeNewest()
    {
        if (_resetsWaiting > 0)
        {
            return null;
        }

        PeerMessage? newest = _newest;
        _newest = null;
        return newest;
    }

    private void Add(PeerMessage command)
    {
        if (_commands.Count >= MostCommandsWaiting)
        {
            report("the peer sends commands faster than they can be obeyed; the newest are dropped.");
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
