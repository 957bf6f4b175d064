using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>
/// What the one peer that counts has said, until the game takes it: commands in their order, of controls and indicators only the newest. A
/// reset voids those that came before it.
/// Each word comes with who says it, under one lock with who counts. So once a peer is gone or another has its place, nothing that it said
/// is given out any more, and the game is told so by a <see cref="PeerGoneMessage"/> before anything that comes after.
/// </summary>
/// <typeparam name="TPeer">Peers; one and the same object is one and the same peer.</typeparam>
internal sealed class PeerInbox<TPeer>
    where TPeer : class
{
    /// <summary>A peer that sends commands faster than the game takes them loses the newest.</summary>
    private const int CommandCapacity = 256;

    private readonly object _gate = new();
    private readonly Queue<PeerMessage> _commands = new();
    private PeerMessage? _newest;
    private TPeer? _peer;
    private bool _isPeerGone;
    private bool _isClosed;

    /// <summary>The peer that counts; null when there is none.</summary>
    public TPeer? Peer
    {
        get
        {
            lock (_gate)
            {
                return _peer;
            }
        }
    }

    /// <summary>Lets a peer count from now on, in the place of another.</summary>
    /// <returns>Who does not count (any more): the other, or the newcomer when the box is closed; null when there is nobody.</returns>
    public TPeer? Welcome(TPeer newcomer)
    {
        lock (_gate)
        {
            return _isClosed ? newcomer : Seat(newcomer);
        }
    }

    /// <summary>Takes it that a peer is gone.</summary>
    /// <returns>Whether it counted until now.</returns>
    public bool Leave(TPeer peer)
    {
        lock (_gate)
        {
            return _peer == peer && Seat(null) is not null;
        }
    }

    /// <summary>Lets nobody count any more.</summary>
    /// <returns>Who did; null for nobody.</returns>
    public TPeer? Close()
    {
        lock (_gate)
        {
            _isClosed = true;
            return Seat(null);
        }
    }

    /// <summary>Puts in what a peer says; if it does not count, that goes nowhere.</summary>
    /// <returns>False when a command was dropped for want of room.</returns>
    public bool TryPut(TPeer peer, PeerMessage message)
    {
        lock (_gate)
        {
            if (_peer != peer)
            {
                return true;
            }

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
            }

            return true;
        }
    }

    /// <summary>Takes a message out: that a peer is gone, then commands, then controls or indicators.</summary>
    public bool TryTake([NotNullWhen(true)] out PeerMessage? message)
    {
        lock (_gate)
        {
            if (_isPeerGone)
            {
                _isPeerGone = false;
                message = new PeerGoneMessage();
            }
            else if (_commands.Count > 0)
            {
                message = _commands.Dequeue();
            }
            else
            {
                message = _newest;
                _newest = null;
            }

            return message is not null;
        }
    }

    private TPeer? Seat(TPeer? peer)
    {
        if (_peer == peer)
        {
            return null;
        }

        TPeer? earlier = _peer;
        _peer = peer;
        _isPeerGone |= earlier is not null;
        _commands.Clear();
        _newest = null;
        return earlier;
    }
}
