using System;
using System.Diagnostics.CodeAnalysis;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using Harvester.Capture.Imaging;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Driving.Bridge;

/// <summary>
/// A bridge over TCP, to one peer at a time: a newer peer takes the place of the older, once it has shown the token where one is asked for. Frames go out as a JSON header and a PNG,
/// messages come in as JSON headers; docs/bridge.md has the protocol. Threads of its own do all the waiting, and a peer that sends
/// nonsense or reads too slowly is cut off, never waited for.
/// </summary>
public sealed class SocketBridge : IDrivingBridge
{
    private readonly SocketBridgeOptions _options;
    private readonly TcpListener _listener;
    private readonly FrameOutbox _outbox;
    private readonly PeerInbox _inbox = new();
    private readonly Thread _acceptor;
    private readonly Thread _sender;
    private readonly object _gate = new();
    private SocketPeer? _peer;
    private volatile bool _stopping;
    private volatile string? _problem;

    /// <summary>Starts to listen.</summary>
    /// <param name="options">Where, and to whom.</param>
    /// <param name="picture">Size of the pictures, pixels.</param>
    /// <exception cref="ArgumentException">The address is not a loopback address and there is no token.</exception>
    /// <exception cref="SocketException">The address or port cannot be had.</exception>
    public SocketBridge(SocketBridgeOptions options, ImageSize picture)
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
        if (!IPAddress.IsLoopback(options.Address) && string.IsNullOrEmpty(options.Token))
        {
            throw new ArgumentException($"Listening at {options.Address}, which others can reach, needs a token.", nameof(options));
        }

        _outbox = new FrameOutbox(picture);
        _listener = new TcpListener(options.Address, options.Port);
        _listener.Start();
        _acceptor = Start(Accept, "Harvester socket bridge: accept");
        _sender = Start(Send, "Harvester socket bridge: send");
    }

    /// <summary>Where the bridge listens, with the port that it was given.</summary>
    public IPEndPoint EndPoint => (IPEndPoint)_listener.LocalEndpoint;

    /// <inheritdoc/>
    public string? Problem => _problem;

    /// <inheritdoc/>
    public void Publish(BridgeState state, PixelBuffer picture) => _outbox.Put(state, picture);

    /// <inheritdoc/>
    public bool TryReceive([NotNullWhen(true)] out PeerMessage? message) => _inbox.TryTake(out message);

    /// <summary>Ends the connection, the listening and the threads.</summary>
    public void Dispose()
    {
        _stopping = true;
        _listener.Stop();
        _outbox.Close();
        Replace(null);
        _acceptor.Join();
        _sender.Join();
    }

    private static Thread Start(ThreadStart run, string name)
    {
        var thread = new Thread(run) { IsBackground = true, Name = name };
        thread.Start();
        return thread;
    }

    private void Accept()
    {
        while (!_stopping)
        {
            try
            {
                SocketPeer.Serve(_listener.AcceptTcpClient(), _options.Token, _inbox, Replace, Leave, problem => _problem = problem);
            }
            catch (Exception e) when (e is SocketException or ObjectDisposedException or InvalidOperationException)
            {
                if (!_stopping)
                {
                    _problem = e.Message;
                    Thread.Sleep(TimeSpan.FromMilliseconds(100));
                }
            }
        }
    }

    private void Send()
    {
        var encoder = new PngEncoder();
        using var png = new System.IO.MemoryStream();
        while (!_stopping)
        {
            if (!_outbox.TryTake(TimeSpan.FromSeconds(1), out BridgeState? state, out PixelBuffer picture) || CurrentPeer() is not { } peer)
            {
                continue;
            }

            png.SetLength(0);
            encoder.Write(picture, png);
            peer.Send(BridgeText.Header(state), new ArraySegment<byte>(png.GetBuffer(), 0, (int)png.Length));
        }
    }

    private SocketPeer? CurrentPeer()
    {
        lock (_gate)
        {
            return _peer;
        }
    }

    private void Replace(SocketPeer? peer)
    {
        SocketPeer? earlier;
        lock (_gate)
        {
            earlier = _peer;
            _peer = _stopping ? null : peer;
            LetGo(earlier);
        }

        earlier?.Dispose();
        if (_stopping)
        {
            peer?.Dispose();
        }
    }

    private void Leave(SocketPeer peer)
    {
        lock (_gate)
        {
            if (_peer == peer)
            {
                _peer = null;
                LetGo(peer);
            }
        }
    }

    /// <summary>A world that a peer has stopped goes on when the peer is gone.</summary>
    private void LetGo(SocketPeer? gone)
    {
        if (gone is { HasStoppedWorld: true })
        {
            _inbox.TryPut(new PauseMessage(false));
        }
    }
}
