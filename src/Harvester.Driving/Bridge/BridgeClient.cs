using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Harvester.Driving.Bridge;

/// <summary>One connection of a socket bridge. It becomes the client once it has sent a valid hello.</summary>
internal sealed class BridgeClient : IDisposable
{
    /// <summary>Size of the send buffer, bytes: less than two images. Linux would let it grow to megabytes.</summary>
    private const int SendBufferBytes = 65_536;

    private readonly TcpClient _connection;
    private readonly SocketReception _reception;
    private bool _isPending = true;
    private volatile bool _isClosed;

    private BridgeClient(TcpClient connection, SocketReception reception)
    {
        _connection = connection;
        _connection.NoDelay = true;
        _connection.SendTimeout = (int)reception.Options.SendPatience.TotalMilliseconds;
        _connection.SendBufferSize = SendBufferBytes;
        KeepAlive.Ask(connection.Client);
        Messages = new MessageStream(connection.GetStream());
        Place = PlaceOf(connection.Client.RemoteEndPoint);
        _reception = reception;
    }

    /// <summary>Address and port of the client.</summary>
    public string Place { get; }

    private bool IsTokenRequired => !string.IsNullOrEmpty(_reception.Options.Token);

    private string WantedHello => IsTokenRequired ? "a hello with the right token" : "a hello";

    /// <summary>
    /// Serves a connection on a thread of its own until it ends. Of the connections that have sent a valid hello, the newest is the client.
    /// </summary>
    public static void Serve(TcpClient connection, SocketReception reception)
    {
        BridgeClient client = Of(connection, reception);
        reception.Pending.Enter(client)?.CutOff("a connection without a hello was closed because too many others were waiting.");
        new Thread(client.Receive) { IsBackground = true, Name = "Harvester socket bridge: receive" }.Start();
    }

    /// <summary>Its messages.</summary>
    public MessageStream Messages { get; }

    /// <summary>Disconnects a client that does not receive its messages.</summary>
    /// <param name="fault">Why not.</param>
    public void Lose(string fault) => CutOff($"the client did not receive a frame: {fault}");

    public void Dispose()
    {
        _isClosed = true;
        _connection.Close();
    }

    /// <summary>Creates a client. The connection may have ended already, so its address may be unknown.</summary>
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
    private static string PlaceOf(EndPoint? end) =>
        end switch
        {
            IPEndPoint { Address.IsIPv4MappedToIPv6: true } mapped => new IPEndPoint(mapped.Address.MapToIPv4(), mapped.Port).ToString(),
            null => "unknown",
            _ => end.ToString() ?? "unknown",
        };

    private void Receive()
    {
        // A timeout of a single read would not suffice: a client that trickles its bytes never exceeds it.
        using var deadline = new Timer(_ => EndWait(), null, _reception.Options.HelloPatience, Timeout.InfiniteTimeSpan);
        try
        {
            while (Messages.ReadHeader() is { } header)
            {
                if (_isPending)
                {
                    BeIntroduced(header);
                    continue;
                }

                ClientMessage message = ClientMessageParser.Parse(header);
                if (message is RestartMessage && !_reception.Options.CanRestart)
                {
                    throw new BridgeException(BridgeProtocol.NoRestart);
                }

                if (!_reception.Inbox.TryPut(this, message))
                {
                    _reception.Report("the client sends commands faster than the game processes them; the newest are dropped.");
                }

                // After the message: a game that sees a frame awaited finds the answer.
                _reception.Outbox.Answer(this, message);
            }

            Dispose();
        }
        catch (BridgeException e)
        {
            Refuse(e.Message, $"the client was disconnected: {e.Message}");
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

    /// <summary>Makes this connection the client. Frames taken for an earlier client are not sent to it.</summary>
    private void BecomeClient()
    {
        BridgeClient? earlier = null;
        _reception.Outbox.Clear(() => earlier = _reception.Inbox.Welcome(this));
        earlier?.Dispose();
    }

    private void BeIntroduced(string header)
    {
        HeaderFields hello = HeaderFields.Parse(header);
        if (
            hello.Text("type") != BridgeProtocol.HelloType
            || (IsTokenRequired && !(hello.Has("token") && SameToken(hello.Text("token"), _reception.Options.Token!)))
        )
        {
            throw new BridgeException($"the first message must be {WantedHello}.");
        }

        BridgeProtocol.CheckClient(hello);
        _isPending = false;
        if (_reception.Pending.TryLeave(this))
        {
            if (Messages.FaultOfWriting(Encoding.UTF8.GetBytes(BridgeProtocol.HelloOfGame), default) is { } fault)
            {
                Lose(fault);
            }

            if (_isClosed)
            {
                _reception.Inbox.CountMissed();
            }
            else
            {
                BecomeClient();
            }
        }
    }

    private void EndWait()
    {
        if (_reception.Pending.TryLeave(this))
        {
            Refuse(
                $"the first message must be {WantedHello}, sent in time.",
                $"a connection was closed because it did not send {WantedHello} in time."
            );
        }
    }

    /// <summary>Compares in a time that does not reveal how much of the token was right.</summary>
    private static bool SameToken(string given, string wanted)
    {
        int difference = given.Length ^ wanted.Length;
        for (int i = 0; i < given.Length; i++)
        {
            difference |= given[i] ^ wanted[i % wanted.Length];
        }

        return difference == 0;
    }

    /// <summary>Disconnects the client and tells it why. When the client reads the reason, the problem has been reported.</summary>
    private void Refuse(string reason, string problem)
    {
        Report(problem);
        Messages.FaultOfWriting(BridgeText.Error(reason), default);
        Dispose();
    }

    private void CutOff(string problem)
    {
        Report(problem);
        Dispose();
    }

    private void Report(string problem)
    {
        if (!_isClosed)
        {
            _reception.Report(problem);
        }
    }
}
