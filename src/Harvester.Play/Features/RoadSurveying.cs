using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>
/// Surveys the roads around the player while it is on, and saves the result in a file that the next survey continues. The file is read and
/// written on another thread.
/// </summary>
public sealed class RoadSurveying : ILastingFeature
{
    private const double SaveEveryMilliseconds = 30_000;
    private const double PrepareEveryMilliseconds = 5_000;
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);
    private readonly IRoadSource _source;
    private readonly Func<Vector3D> _place;
    private readonly string _path;
    private readonly GrowingRoads _roads;
    private readonly PlayerMessages _messages;
    private readonly IClock _clock;
    private readonly DiskQueue _disk = new();
    private Task<RoadSurvey>? _loading;
    private RoadSurvey? _survey;
    private double _savedAt;
    private double _preparedAt = double.NegativeInfinity;
    private int _savedFindings;
    private int _preparedFindings;
    private RoadSurveyStatus _status;
    private bool _wereLanesWanted;

    /// <summary>Creates a survey that is off.</summary>
    /// <param name="source">The game's roads.</param>
    /// <param name="place">Returns the player's position.</param>
    /// <param name="path">The file.</param>
    /// <param name="roads">Receives the roads as the survey finds them.</param>
    /// <param name="messages">Reports the result.</param>
    /// <param name="clock">Real time.</param>
    public RoadSurveying(IRoadSource source, Func<Vector3D> place, string path, GrowingRoads roads, PlayerMessages messages, IClock clock)
    {
        _source = source;
        _place = place;
        _path = path;
        _roads = roads;
        _messages = messages;
        _clock = clock;
    }

    /// <inheritdoc/>
    public string Name => "The road survey";

    /// <inheritdoc/>
    public bool IsOn { get; private set; }

    /// <summary>A line about the survey; null if it is off.</summary>
    public string? Line =>
        IsOn
            ? FormattableString.Invariant($"SURVEY  {_status.Nodes} nodes  {_status.Links} links  {_status.Waiting} waiting")
                + (_status.IsLoaded ? string.Empty : "  (the game is loading)")
            : null;

    /// <summary>Whether a feature needs lanes: the survey then switches itself on.</summary>
    public Func<bool> AreLanesWanted { get; init; } = static () => false;

    /// <summary>Whether the survey provides the lanes; false if the roads come from elsewhere.</summary>
    public bool GivesLanes { get; init; } = true;

    /// <summary>Whether the file is being read or written, or roads are being prepared.</summary>
    public bool IsBusy => _loading is { IsCompleted: false } || _disk.IsBusy || _roads.IsPreparing;

    /// <summary>Switches the survey on or off, with a message.</summary>
    public void Toggle()
    {
        if (IsOn)
        {
            Stop();
            string found = $"{Counted.Of(_status.Nodes, "node")} and {Counted.Of(_status.Links, "link")}";
            _messages.Tell($"The road survey is off: {found}, in {_path}.");
        }
        else
        {
            Start();
            _messages.Tell("The road survey is on: drive along the roads that you want to record.");
        }
    }

    /// <summary>Switches the survey on.</summary>
    public void Start()
    {
        IsOn = true;
        _savedAt = _clock.Milliseconds;
        _loading ??= Task.Run(() => new RoadSurvey(_source, RoadSurveyFile.Load(_path)));
    }

    /// <inheritdoc/>
    public void Tick()
    {
        ThrowIfNotSaved();
        if (_roads.TakeFailure() is { } failure)
        {
            _messages.TellFailure("Reading the roads", failure);
        }

        bool isWanted = AreLanesWanted();
        if (isWanted && !_wereLanesWanted)
        {
            Start();
        }

        _wereLanesWanted = isWanted;
        if (!IsOn || _loading is not { } loading || !Background.IsDone(nameof(RoadSurvey), () => loading.IsCompleted))
        {
            return;
        }

        if (loading.IsFaulted)
        {
            // An empty survey is not continued: it would overwrite the file.
            _loading = null;
            throw new InvalidDataException($"{_path}: {loading.Exception!.InnerException!.Message} Repair it or move it away.");
        }

        _survey = loading.Result;
        _status = _survey.Step(_place());
        OfferRoads(_survey);
        if (_clock.Milliseconds - _savedAt > SaveEveryMilliseconds)
        {
            Save();
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        if (IsOn)
        {
            IsOn = false;
            Save();
        }
    }

    /// <summary>Stops, and waits until the file is written, or for as long as a script may take to end.</summary>
    public void Finish()
    {
        Stop();
        _disk.Wait(MaxWaitForDisk);
        ThrowIfNotSaved();
    }

    private void OfferRoads(RoadSurvey survey)
    {
        bool isNews = _status.Links > 0 && _status.Findings > _preparedFindings;
        if (GivesLanes && isNews && !_roads.IsPreparing && _clock.Milliseconds - _preparedAt > PrepareEveryMilliseconds)
        {
            _preparedFindings = _status.Findings;
            _preparedAt = _clock.Milliseconds;
            RoadNetwork network = survey.ToNetwork();
            _roads.Prepare(() => network, "game");
        }
    }

    private void Save()
    {
        if (_survey is null || _status.Findings == _savedFindings)
        {
            return;
        }

        _savedAt = _clock.Milliseconds;
        _savedFindings = _status.Findings;
        RoadNetwork network = _survey.ToNetwork();
        _disk.Add(() =>
        {
            Directory.CreateDirectory(Path.GetDirectoryName(_path)!);
            RoadSurveyFile.Save(_path, network);
        });
    }

    private void ThrowIfNotSaved()
    {
        if (_disk.TakeFailure() is { } failure)
        {
            _savedFindings = 0;
            throw new IOException(failure.Message, failure);
        }
    }
}
