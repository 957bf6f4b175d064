using System;
using System.IO;
using System.Net.Sockets;
using System.Threading;

namespace Harvester.Capture.Driving.Bridge;

/// <summary>One connection of a socket bridge. It is welcome once it has shown the token, or at once where none is asked for.</summary>
internal sealed class SocketPeer : IDisposable
{
    /// <summary>A peer that has not taken a frame, or not shown the token, for so long is cut off, milliseconds.</summary>
    private const int Patience = 2000;

    private readonly TcpClient _client;
    private readonly NetworkStream _stream;
    private readonly string? _token;
    private readonly PeerInbox _inbox;
    private readonly Action<SocketPeer> _welcome;
    private readonly Action<SocketPeer> _leave;
    private readonly Action<string> _report;
    private readonly object _sending = new();
    private volatile bool _isWelcome;
    private volatile bool _isClosed;

    private SocketPeer(TcpClient client, string? token, PeerInbox inbox, Action<SocketPeer> welcome, Action<SocketPeer> leave, Action<string> report)
    {
        _client = client;
        _client.NoDelay = true;
        _client.SendTimeout = Patience;
        _stream = client.GetStream();
        _token = token;
        _inbox = inbox;
        _welcome = welcome;
        _leave = leave;
        _report = report;
    }

    /// <summary>Whether the world stands by this peer's word.</summary>
    public bool HasStoppedWorld { get; private set; }

    /// <summary>Serves a connection on a thread of its own until it ends.</summary>
    public static void Serve(
        TcpClient client, string? token, PeerInbox inbox, Action<SocketPeer> welcome, Action<SocketPeer> leave, Action<string> report)
    {
        var peer = new SocketPeer(client, token, inbox, welcome, leave, report);
        new Thread(peer.Receive) { IsBackground = true, Name = "Harvester socket bridge: receive" }.Start();
    }

    /// <summary>Sends a message; a peer that does not take it is cut off.</summary>
    public void Send(byte[] header, ArraySegment<byte> payload)
    {
        try
        {
            lock (_sending)
            {
                SocketFraming.Write(_stream, header, payload);
            }
        }
        catch (Exception e) when (e is IOException or InvalidOperationException)
        {
            // A stream that another thread has just closed is disposed, or says that it does not support writing.
            CutOff($"the peer did not take a frame: {e.Message}");
        }
    }

    public void Dispose()
    {
        _isClosed = true;
        _client.Close();
    }

    private void Receive()
    {
        // A limit of a single read would not do: a peer that trickles its bytes never keeps one waiting.
        using Timer? deadline = _token is null ? null : new Timer(_ => EndWait(), null, Patience, Timeout.Infinite);
        try
        {
            if (_token is null)
            {
                Welcome();
            }

            while (SocketFraming.ReadHeader(_stream) is { } header)
            {
                Take(header);
            }

            Dispose();
        }
        catch (BridgeException e)
        {
            Send(BridgeText.Error(e.Message), default);
            CutOff($"the peer was cut off: {e.Message}");
        }
        catch (Exception e) when (e is IOException or InvalidOperationException)
        {
            CutOff($"the peer went away: {e.Message}");
        }

        _leave(this);
    }

    private void Take(string header)
    {
        if (!_isWelcome)
        {
            JsonFields hello = JsonFields.Parse(header);
            if (hello.Text("type") != "hello" || !SameToken(hello.Text("token"), _token!))
            {
                throw new BridgeException("the first message must be a hello with the right token.");
            }

            Welcome();
            return;
        }

        PeerMessage message = PeerMessageParser.Parse(header);
        HasStoppedWorld = message is PauseMessage pause ? pause.IsPaused : HasStoppedWorld || message is StepMessage;
        if (!_inbox.TryPut(message))
        {
            _report("the peer sends commands faster than the game takes them; the newest are dropped.");
        }
    }

    private void EndWait()
    {
        if (!_isWelcome)
        {
            CutOff("a peer was cut off that did not show the token in time.");
        }
    }

    private void Welcome()
    {
        _isWelcome = true;
        _welcome(this);
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
            _report(problem);
        }

        Dispose();
    }
}
