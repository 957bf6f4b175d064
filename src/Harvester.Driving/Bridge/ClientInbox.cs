using System.Diagnostics.CodeAnalysis;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Messages of the current client, until the game takes them: commands in order; of controls and indicators only the newest. A reset or
/// restart voids controls and indicators received before it. Sender and message are stored under one lock with the current client, so once
/// a client has disconnected or been replaced, none of its messages is handed out, and a <see cref="ClientGoneMessage"/> precedes all that
/// follows.
/// </summary>
/// <typeparam name="TClient">Clients, compared by reference.</typeparam>
internal sealed class ClientInbox<TClient> : IClientInbox
    where TClient : class
{
    private readonly object _gate = new();
    private readonly MessageQueue _messages = new();
    private TClient? _client;
    private int _clientsGone;
    private bool _isClientGone;
    private bool _isClosed;

    /// <summary>The current client; null if there is none.</summary>
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

    /// <inheritdoc/>
    public bool HasClientGone
    {
        get
        {
            lock (_gate)
            {
                return _isClientGone;
            }
        }
    }

    /// <summary>Makes a client the current one, in place of another.</summary>
    /// <returns>The client to disconnect: the earlier one, or the newcomer if the inbox is closed; null if there is none.</returns>
    public TClient? Welcome(TClient newcomer)
    {
        lock (_gate)
        {
            return _isClosed ? newcomer : SetClient(newcomer);
        }
    }

    /// <summary>Makes a client the current one as if it were another than before, and had just come.</summary>
    public void Renew(TClient client)
    {
        lock (_gate)
        {
            SetClient(null);
            SetClient(client);
        }
    }

    /// <summary>Removes a client that has disconnected.</summary>
    /// <returns>Whether it was the current one.</returns>
    public bool Leave(TClient client)
    {
        lock (_gate)
        {
            return _client == client && SetClient(null) is not null;
        }
    }

    /// <summary>Removes the current client and accepts no other.</summary>
    /// <returns>The client that was removed; null if there was none.</returns>
    public TClient? Close()
    {
        lock (_gate)
        {
            _isClosed = true;
            return SetClient(null);
        }
    }

    /// <summary>Number of clients that have disconnected or been replaced, also before they were the current one.</summary>
    public int ClientsGone
    {
        get
        {
            lock (_gate)
            {
                return _clientsGone;
            }
        }
    }

    /// <summary>Counts a client that has disconnected before it could be the current one.</summary>
    public void CountMissed()
    {
        lock (_gate)
        {
            _clientsGone++;
        }
    }

    /// <summary>Stores a message of a client. A message of any client but the current one is ignored.</summary>
    /// <returns>False if a command was dropped because the inbox is full.</returns>
    public bool TryPut(TClient client, ClientMessage message)
    {
        lock (_gate)
        {
            if (_client != client)
            {
                return true;
            }

            if (!_messages.TryAdd(message))
            {
                return false;
            }

            if (message is RestartMessage)
            {
                _messages.TakeNewest();
            }

            Monitor.PulseAll(_gate);
            return true;
        }
    }

    /// <summary>Takes the next message: first that a client is gone, then commands, then controls or indicators.</summary>
    public bool TryReceive([NotNullWhen(true)] out ClientMessage? message)
    {
        lock (_gate)
        {
            if (_isClientGone)
            {
                _isClientGone = false;
                message = new ClientGoneMessage();
            }
            else if (!_messages.TryTakeCommand(out message))
            {
                message = _messages.TakeNewest();
            }

            return message is not null;
        }
    }

    /// <summary>Waits until there is a message to take.</summary>
    /// <param name="patience">Maximum time to wait.</param>
    /// <returns>Whether there is one.</returns>
    public bool Await(TimeSpan patience)
    {
        lock (_gate)
        {
            return HasMessage || (Monitor.Wait(_gate, patience) && HasMessage);
        }
    }

    private bool HasMessage => _isClientGone || !_messages.IsEmpty;

    private TClient? SetClient(TClient? client)
    {
        if (_client == client)
        {
            return null;
        }

        TClient? earlier = _client;
        _client = client;
        _clientsGone += earlier is null ? 0 : 1;
        _isClientGone |= earlier is not null;
        _messages.Clear();
        Monitor.PulseAll(_gate);
        return earlier;
    }
}
