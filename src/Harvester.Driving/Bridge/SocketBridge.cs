using System.Net;
using System.Net.Sockets;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Driving.Bridge;

/// <summary>
/// A bridge over TCP, to one client at a time. A newer client replaces the older one once it has sent a valid hello, with the token if one
/// is required. Frames are sent as a JSON header and a PNG; messages are JSON headers; docs/bridge.md specifies the protocol. Threads of
/// its own do all the waiting. A client that sends invalid messages or does not receive a frame is disconnected. A client is sent the
/// newest frame when it has answered the last one.
/// </summary>
public sealed class SocketBridge : IAwaitableBridge
{
    private readonly TcpListener _listener;
    private readonly SocketReception _reception;
    private readonly Thread _acceptor;
    private readonly Thread _sender;
    private volatile bool _stopping;
    private volatile string? _problem;

    /// <summary>Starts listening for clients.</summary>
    /// <param name="options">Address, port and token.</param>
    /// <param name="picture">Size of the images, pixels.</param>
    /// <exception cref="ArgumentException">The address is not a loopback address and there is no token.</exception>
    /// <exception cref="SocketException">The address or port is not available.</exception>
    public SocketBridge(SocketBridgeOptions options, ImageSize picture)
    {
        if (options is null)
        {
            throw new ArgumentNullException(nameof(options));
        }

        if (!IPAddress.IsLoopback(options.Address) && string.IsNullOrEmpty(options.Token))
        {
            throw new ArgumentException($"Listening at {options.Address}, which others can reach, needs a token.", nameof(options));
        }

        var inbox = new ClientInbox<BridgeClient>();
        _reception = new SocketReception(
            options,
            inbox,
            new PendingClients<BridgeClient>(options.MaxPending),
            new FrameOutbox<BridgeClient>(picture, inbox, needsAnswers: true),
            problem => _problem = problem
        );
        _listener = new TcpListener(options.Address, options.Port);
        _listener.Start();
        _acceptor = Start(Accept, "Harvester socket bridge: accept");
        _sender = Start(Send, "Harvester socket bridge: send");
    }

    /// <summary>The address and port at which the bridge listens; the port is the actual one if 0 was requested.</summary>
    public IPEndPoint EndPoint => (IPEndPoint)_listener.LocalEndpoint;

    /// <inheritdoc/>
    public string? Problem => _problem;

    /// <inheritdoc/>
    public string? Client => _reception.Inbox.Client?.Place;

    /// <inheritdoc/>
    public int ClientsGone => _reception.Inbox.ClientsGone;

    /// <summary>Number of connections that have not sent a valid hello yet.</summary>
    internal int Pending => _reception.Pending.Count;

    /// <inheritdoc/>
    public IClientInbox Inbox => _reception.Inbox;

    /// <inheritdoc/>
    public IFrameOutbox Outbox => _reception.Outbox;

    /// <inheritdoc/>
    public bool AwaitMessage(TimeSpan patience) => _reception.Inbox.Await(patience);

    /// <summary>
    /// Closes all connections, stops listening and ends the threads. Waits for a frame in transmission, at most
    /// <see cref="SocketBridgeOptions.SendPatience"/>.
    /// </summary>
    public void Dispose()
    {
        _stopping = true;
        _listener.Stop();
        _reception.Outbox.Close();

        // A frame in transmission is sent completely, if the client receives it.
        _sender.Join(_reception.Options.SendPatience);
        _reception.Inbox.Close()?.Dispose();
        foreach (BridgeClient stranger in _reception.Pending.Close())
        {
            stranger.Dispose();
        }

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
                BridgeClient.Serve(_listener.AcceptTcpClient(), _reception);
            }
#pragma warning disable CA1031 // An exception that leaves a thread ends the game, whatever its type.
            catch (Exception e) when (e is not ThreadAbortException)
#pragma warning restore CA1031
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
            // Without a client, frames are taken and dropped.
            if (
                _reception.Outbox.TryTake(
                    TimeSpan.FromSeconds(1),
                    out BridgeState? state,
                    out PixelBuffer picture,
                    out BridgeClient? client
                ) && client is not null
            )
            {
                png.SetLength(0);
                if (state.HasPicture)
                {
                    encoder.Write(picture, png);
                }

                var payload = new ArraySegment<byte>(png.GetBuffer(), 0, (int)png.Length);
                if (client.Messages.FaultOfWriting(BridgeText.Header(state), payload) is { } fault)
                {
                    client.Lose(fault);
                }
            }
        }
    }
}
