using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>
/// What the one client that counts has said, until the game takes it: commands in their order, of controls and indicators only the newest.
/// A reset voids those that came before it. Each word comes with who says it, under one lock with who counts. So once a client is gone or
/// another has its place, nothing that it said is given out any more, and the game is told so by a <see cref="ClientGoneMessage"/> before
/// anything that comes after.
/// </summary>
/// <typeparam name="TClient">Clients; one and the same object is one and the same client.</typeparam>
internal sealed class ClientInbox<TClient>
    where TClient : class
{
    /// <summary>A client that sends commands faster than the game takes them loses the newest.</summary>
    private const int CommandCapacity = 256;

    private readonly object _gate = new();
    private readonly Queue<ClientMessage> _commands = new();
    private ClientMessage? _newest;
    private TClient? _client;
    private bool _isClientGone;
    private bool _isClosed;

    /// <summary>The client that counts; null when there is none.</summary>
    public TClient? Client
    {
        get
        {
            lock (_gate)
            {
                return _client;
            }
        }
    }

    /// <summary>Lets a client count from now on, in the place of another.</summary>
    /// <returns>Who does not count (any more): the other, or the newcomer when the box is closed; null when there is nobody.</returns>
    public TClient? Welcome(TClient newcomer)
    {
        lock (_gate)
        {
            return _isClosed ? newcomer : Seat(newcomer);
        }
    }

    /// <summary>Takes it that a client is gone.</summary>
    /// <returns>Whether it counted until now.</returns>
    public bool Leave(TClient client)
    {
        lock (_gate)
        {
            return _client == client && Seat(null) is not null;
        }
    }

    /// <summary>Lets nobody count any more.</summary>
    /// <returns>Who did; null for nobody.</returns>
    public TClient? Close()
    {
        lock (_gate)
        {
            _isClosed = true;
            return Seat(null);
        }
    }

    /// <summary>Puts in what a client says; if it does not count, that goes nowhere.</summary>
    /// <returns>False when a command was dropped for want of room.</returns>
    public bool TryPut(TClient client, ClientMessage message)
    {
        lock (_gate)
        {
            if (_client != client)
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

    /// <summary>Takes a message out: that a client is gone, then commands, then controls or indicators.</summary>
    public bool TryTake([NotNullWhen(true)] out ClientMessage? message)
    {
        lock (_gate)
        {
            if (_isClientGone)
            {
                _isClientGone = false;
                message = new ClientGoneMessage();
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

    private TClient? Seat(TClient? client)
    {
        if (_client == client)
        {
            return null;
        }

        TClient? earlier = _client;
        _client = client;
        _isClientGone |= earlier is not null;
        _commands.Clear();
        _newest = null;
        return earlier;
    }
}
