using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace Harvester.Driving.Bridge;

/// <summary>One connection of a socket bridge. It counts once it has shown the token, or at once where none is asked for.</summary>
internal sealed class BridgeClient : IDisposable
{
    /// <summary>What the network may hold back on this side, bytes: less than two pictures. Linux would let it grow to megabytes.</summary>
    private const int SendBufferBytes = 65_536;

    private readonly TcpClient _connection;
    private readonly NetworkStream _stream;
    private readonly SocketReception _reception;
    private readonly FrameCredit _credit = new();
    private readonly object _sending = new();
    private bool _isPending;
    private volatile bool _isClosed;

    private BridgeClient(TcpClient connection, SocketReception reception)
    {
        _connection = connection;
        _connection.NoDelay = true;
        _connection.SendTimeout = (int)reception.Options.SendPatience.TotalMilliseconds;
        _connection.SendBufferSize = SendBufferBytes;
        KeepAlive.Ask(connection.Client);
        _stream = connection.GetStream();
        Place = PlaceOf(connection.Client.RemoteEndPoint);
        _reception = reception;
        _isPending = !string.IsNullOrEmpty(reception.Options.Token);
    }

    /// <summary>Address and port of the other side.</summary>
    public string Place { get; }

    /// <summary>
    /// Serves a connection on a thread of its own until it ends. Of connections without a token the one served last counts.
    /// </summary>
    public static void Serve(TcpClient connection, SocketReception reception)
    {
        BridgeClient client = Of(connection, reception);
        if (client._isPending)
        {
            reception.Pending.Enter(client)?.CutOff("a connection without the token was closed because too many others were waiting.");
        }
        else
        {
            client.BeWelcome();
        }

        new Thread(client.Receive) { IsBackground = true, Name = "Harvester socket bridge: receive" }.Start();
    }

    /// <summary>Whether the client may be sent a frame now; it counts as sent then.</summary>
    public bool MayGet(BridgeState state) => _credit.TrySpend(state);

    /// <summary>Sends a message; a client that does not take it is cut off.</summary>
    public void Send(byte[] header, ArraySegment<byte> payload)
    {
        try
        {
            lock (_sending)
            {
                SocketFraming.Write(_stream, header, payload);
            }
        }
#pragma warning disable CA1031 // An exception that leaves a thread ends the game, whatever its type.
        catch (Exception e) when (e is not ThreadAbortException)
#pragma warning restore CA1031
        {
            CutOff($"the client did not receive a frame: {e.Message}");
        }
    }

    public void Dispose()
    {
        _isClosed = true;
        _connection.Close();
    }

    /// <summary>A connection may have ended before anything of it can be asked for.</summary>
    private static BridgeClient Of(TcpClient connection, SocketReception reception)
    {
        try
        {
            return new BridgeClient(connection, reception);
        }
        catch
        {
            connection.Dispose();
            throw;
        }
    }

    /// <summary>A dual-mode socket reports IPv4 addresses in IPv6-mapped form; this is the plain form.</summary>
    private static string PlaceOf(EndPoint? end) => end switch
    {
        IPEndPoint { Address.IsIPv4MappedToIPv6: true } mapped => new IPEndPoint(mapped.Address.MapToIPv4(), mapped.Port).ToString(),
        null => "unknown",
        _ => end.ToString() ?? "unknown",
    };

    private void Receive()
    {
        // A limit of a single read would not do: a client that trickles its bytes never keeps one waiting.
        using Timer? deadline = _isPending ? new Timer(_ => EndWait(), null, _reception.Options.TokenPatience, Timeout.InfiniteTimeSpan)
            : null;
        try
        {
            while (SocketFraming.ReadHeader(_stream) is { } header)
            {
                Take(header);
            }

            Dispose();
        }
        catch (BridgeException e)
        {
            Send(BridgeText.Error(e.Message), default);
            CutOff($"the client was disconnected: {e.Message}");
        }
#pragma warning disable CA1031 // An exception that leaves a thread ends the game, whatever its type.
        catch (Exception e) when (e is not ThreadAbortException)
#pragma warning restore CA1031
        {
            CutOff($"the client disconnected: {e.Message}");
        }

        _reception.Pending.TryLeave(this);
        _reception.Inbox.Leave(this);
    }

    private void Take(string header)
    {
        if (_isPending)
        {
            ShowToken(header);
        }
        else
        {
            Hear(ClientMessageParser.Parse(header));
        }
    }

    private void Hear(ClientMessage word)
    {
        _credit.Hear(word);
        _reception.Outbox.Wake();
        if (!_reception.Inbox.TryPut(this, word))
        {
            _reception.Report("the client sends commands faster than the game processes them; the newest are dropped.");
        }
    }

    /// <summary>Counts from now on, and is sent nothing that was taken for another.</summary>
    private void BeWelcome()
    {
        BridgeClient? earlier = null;
        _reception.Outbox.Clear(() => earlier = _reception.Inbox.Welcome(this));
        earlier?.Dispose();
    }

    private void ShowToken(string header)
    {
        JsonFields hello = JsonFields.Parse(header);
        if (hello.Text("type") != "hello" || !SameToken(hello.Text("token"), _reception.Options.Token!))
        {
            throw new BridgeException("the first message must be a hello with the right token.");
        }

        _isPending = false;
        if (_reception.Pending.TryLeave(this))
        {
            BeWelcome();
        }
    }

    private void EndWait()
    {
        if (_reception.Pending.TryLeave(this))
        {
            Send(BridgeText.Error("the first message must be a hello with the right token, sent in time."), default);
            CutOff("a connection was closed because it did not send the token in time.");
        }
    }

    /// <summary>Compares in a time that does not tell how much of the token was right.</summary>
    private static bool SameToken(string given, string wanted)
    {
        int difference = given.Length ^ wanted.Length;
        for (int i = 0; i < given.Length; i++)
        {
            difference |= given[i] ^ wanted[i % wanted.Length];
        }

        return difference == 0;
    }

    private void CutOff(string problem)
    {
        if (!_isClosed)
        {
            _reception.Report(problem);
        }

        Dispose();
    }
}
