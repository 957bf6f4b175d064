using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The bridge of Figure 23 of the thesis: two machines share a folder. The game writes an image per frame and state.txt with the thirteen
/// indicators; the client writes indicators.txt or controls.txt, and commands as command.json. Files are renamed into place, so each
/// appears complete. A thread of its own does all disk work. A folder does not show who writes or whether anybody still does: a client
/// counts as disconnected after a time without new files, and a hello begins a new one.
/// </summary>
public sealed class FolderBridge : IAwaitableBridge
{
    /// <summary>
    /// Default time without a sign of life after which a client counts as disconnected, seconds: enough for a learner between two steps.
    /// </summary>
    public const double DefaultPatienceSeconds = 30;

    private const double MillisecondsPerSecond = 1000;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(5);

    /// <summary>A folder on another machine may block the thread for minutes.</summary>
    private static readonly TimeSpan MaxWaitForThread = TimeSpan.FromSeconds(5);

    private readonly string _folder;
    private readonly double _patienceSeconds;
    private readonly IClock _clock;
    private readonly FrameOutbox<FolderBridge> _outbox;
    private readonly FrameFiles _frames;
    private readonly ClientInbox<FolderBridge> _inbox = new();
    private readonly WatchedFile _indicators;
    private readonly WatchedFile _controls;
    private readonly WatchedFile _command;
    private readonly WatchedFile _alive;
    private readonly WriterLock _lock;
    private readonly Thread _thread;
    private double _heardMilliseconds;
    private volatile bool _stopping;
    private volatile string? _problem;

    /// <summary>Opens the bridge. Files that a client left in the folder earlier are ignored.</summary>
    /// <param name="folder">The shared folder; it is created if it does not exist.</param>
    /// <param name="picture">Size of the images, pixels.</param>
    /// <param name="patienceSeconds">Time without a sign of life after which the client counts as disconnected, real seconds.</param>
    /// <exception cref="FolderLockedException">Another process serves a game over the folder.</exception>
    /// <exception cref="IOException">The folder cannot be created.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be created.</exception>
    public FolderBridge(string folder, ImageSize picture, double patienceSeconds = DefaultPatienceSeconds)
        : this(folder, picture, patienceSeconds, new PlayerClock()) { }

    internal FolderBridge(string folder, ImageSize picture, double patienceSeconds, IClock clock)
    {
        _folder = folder ?? throw new ArgumentNullException(nameof(folder));
        _patienceSeconds = patienceSeconds;
        _clock = clock;
        _lock = WriterLock.Take(folder);
        try
        {
            Directory.CreateDirectory(folder);
        }
        catch
        {
            _lock.Dispose();
            throw;
        }

        _outbox = new FrameOutbox<FolderBridge>(picture, _inbox, needsAnswers: false);
        _frames = new FrameFiles(folder);
        _indicators = Watched("indicators.txt");
        _controls = Watched("controls.txt");
        _command = Watched("command.json");
        _alive = Watched("alive.txt");
        _thread = new Thread(Run) { IsBackground = true, Name = "Harvester folder bridge" };
        _thread.Start();
    }

    /// <inheritdoc/>
    public string? Problem => _problem;

    /// <inheritdoc/>
    public string? Client => _inbox.Client is null ? null : _folder;

    /// <inheritdoc/>
    public IClientInbox Inbox => _inbox;

    /// <inheritdoc/>
    public IFrameOutbox Outbox => _outbox;

    /// <inheritdoc/>
    public bool AwaitMessage(TimeSpan patience) => _inbox.Await(patience);

    /// <inheritdoc/>
    public int ClientsGone => _inbox.ClientsGone;

    /// <summary>Ends the bridge's thread; the last files stay in the folder.</summary>
    public void Dispose()
    {
        _stopping = true;
        _outbox.Close();
        _thread.Join(MaxWaitForThread);
        _lock.Dispose();
    }

    private WatchedFile Watched(string name)
    {
        var file = new WatchedFile(Path.Combine(_folder, name));
        file.TrySee();
        return file;
    }

    private void Run()
    {
        using FrameFiles frames = _frames;
        Try(frames.DeleteEarlier);
        Try(frames.WriteHello);
        while (!_stopping)
        {
            Try(Send);
            Try(() => Receive(_command, TakeCommand));
            Try(() => Receive(_indicators, text => Put(() => FolderMessages.ParseIndicators(text))));
            Try(() => Receive(_controls, text => Put(() => FolderMessages.ParseControls(text))));
            Try(Listen);
        }
    }

    /// <summary>
    /// Runs an action and records its failure. A disk may work again a moment later, and a client may correct a bad file, so the bridge
    /// goes on.
    /// </summary>
    private void Try(Action action)
    {
        try
        {
            action();
        }
#pragma warning disable CA1031 // An exception that leaves a thread ends the game, whatever its type.
        catch (Exception e) when (e is not ThreadAbortException)
#pragma warning restore CA1031
        {
            _problem = e.Message;
        }
    }

    private void Send()
    {
        if (_outbox.TryTake(Poll, out BridgeState? state, out PixelBuffer picture, out _))
        {
            _frames.Put(state, picture);
        }

        _frames.Write();
    }

    private static void Receive(WatchedFile file, Action<string> take)
    {
        if (file.TryReadNew(out string? text))
        {
            take(text);
        }
    }

    private void TakeCommand(string text)
    {
        HeaderFields command = HeaderFields.Parse(text);
        if (command.Text("type") == BridgeProtocol.HelloType)
        {
            if (command.Has("version"))
            {
                BridgeProtocol.CheckClient(command);
            }

            _heardMilliseconds = _clock.Milliseconds;
            _outbox.Clear(() => _inbox.Renew(this));
        }
        else
        {
            Put(() => ClientMessageParser.Parse(text));
        }
    }

    private void Put(Func<ClientMessage> parse)
    {
        // A client that writes nonsense is there, too.
        MarkAlive();
        if (!_inbox.TryPut(this, parse()))
        {
            _problem = "the client sends commands faster than the game processes them; the newest are dropped.";
        }
    }

    private void Listen()
    {
        if (_alive.TrySee())
        {
            MarkAlive();
        }
        else if (_clock.Milliseconds - _heardMilliseconds > _patienceSeconds * MillisecondsPerSecond && _inbox.Leave(this))
        {
            _problem = FormattableString.Invariant($"no message from the client for {_patienceSeconds} s; it counts as disconnected.");
        }
    }

    private void MarkAlive()
    {
        _heardMilliseconds = _clock.Milliseconds;
        _inbox.Welcome(this);
    }
}
