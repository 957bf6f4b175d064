using Harvester.Geometry.Lanes;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Statistics;

/// <summary>Statistics of sessions, collected in one pass over their labels.</summary>
public sealed class SessionStatistics
{
    /// <summary>Height below which KITTI's benchmark does not evaluate objects, pixels.</summary>
    public const double SmallPixels = 25;

    private const int MaxWeathers = 1000;
    private const double FarMetres = 150;
    private const int DistanceBins = 15;
    private const double LargeSidePixels = 400;
    private const int SideBins = 20;
    private const int FractionBins = 10;

    private readonly SortedDictionary<ObjectClass, ClassStatistics> _classes = [];
    private readonly SortedDictionary<string, int> _framesOfWeathers = new(StringComparer.Ordinal);
    private readonly SortedDictionary<int, int> _framesOfHours = [];
    private readonly SortedDictionary<string, IndicatorSpan> _indicators = new(StringComparer.Ordinal);
    private readonly SortedDictionary<EventKind, int> _events = [];
    private HashSet<EventMark> _open = [];
    private int _session;

    /// <summary>Collects the statistics of one session.</summary>
    public static SessionStatistics Of(IEnumerable<FrameLabel> labels) => Of([labels]);

    /// <summary>Collects the statistics of several sessions. Objects of different sessions are different, even with equal ids.</summary>
    public static SessionStatistics Of(IEnumerable<IEnumerable<FrameLabel>> sessions)
    {
        var statistics = new SessionStatistics();
        foreach (IEnumerable<FrameLabel> labels in sessions)
        {
            foreach (FrameLabel label in labels)
            {
                statistics.Add(label);
            }

            statistics._session++;
            statistics._open = [];
        }

        return statistics;
    }

    /// <summary>Number of events by kind that open at a frame and were not open at the one before; null without events.</summary>
    public IReadOnlyDictionary<EventKind, int>? Events { get; private set; }

    /// <summary>Number of frames.</summary>
    public int Frames { get; private set; }

    /// <summary>Number of labels of all classes.</summary>
    public int Labels => _classes.Values.Sum(kind => kind.Labels);

    /// <summary>Labels per frame; 0 without frames.</summary>
    public double LabelsPerFrame => Frames == 0 ? 0 : (double)Labels / Frames;

    /// <summary>Number of labels of kinds that KITTI labels too: all but signs, traffic lights and riders of two-wheelers.</summary>
    public int LabelsAsKitti => _classes.Where(kind => KittiScope.Has(kind.Key)).Sum(kind => kind.Value.Labels);

    /// <summary>These labels per frame; 0 without frames.</summary>
    public double LabelsAsKittiPerFrame => Frames == 0 ? 0 : (double)LabelsAsKitti / Frames;

    /// <summary>Statistics by class, in the order of the classes; only classes that occur.</summary>
    public IReadOnlyDictionary<ObjectClass, ClassStatistics> Classes => _classes;

    /// <summary>The weathers that occur, in alphabetical order.</summary>
    public IReadOnlyCollection<string> Weathers => _framesOfWeathers.Keys;

    /// <summary>Number of frames with each weather, in alphabetical order.</summary>
    public IReadOnlyDictionary<string, int> FramesOfWeathers => _framesOfWeathers;

    /// <summary>Number of frames with each hour of the day, 0 to 23; only hours that occur.</summary>
    public IReadOnlyDictionary<int, int> FramesOfHours => _framesOfHours;

    /// <summary>Ranges of the lane indicators; only indicators that are valid in some frame.</summary>
    public IReadOnlyDictionary<string, IndicatorSpan> Indicators => _indicators;

    /// <summary>Game time of the first frame, seconds.</summary>
    public double FirstTimeSeconds { get; private set; }

    /// <summary>Game time of the last frame, seconds.</summary>
    public double LastTimeSeconds { get; private set; }

    /// <summary>How the car's position in its lane varies.</summary>
    public LaneVariety Lanes { get; } = new();

    /// <summary>Where the geometry of the lanes comes from.</summary>
    public LaneSources LaneSources { get; } = new();

    /// <summary>Number of labels whose box is lower than <see cref="SmallPixels"/>.</summary>
    public int SmallLabels { get; private set; }

    /// <summary>The classes without labels, in their order.</summary>
    public IEnumerable<ObjectClass> MissingClasses => Enum.GetValues<ObjectClass>().Except(_classes.Keys);

    /// <summary>Labels by distance, metres.</summary>
    public Histogram Distances { get; } = Histogram.Even(FarMetres, DistanceBins);

    /// <summary>Labels by height of the box in the image, pixels.</summary>
    public Histogram BoxHeights { get; } = Histogram.Even(LargeSidePixels, SideBins);

    /// <summary>Labels by width of the box in the image, pixels.</summary>
    public Histogram BoxWidths { get; } = Histogram.Even(LargeSidePixels, SideBins);

    /// <summary>
    /// Labels by area of the box in the image, square pixels. The bins are squares with sides from 8 to 512 pixels, including COCO's limits
    /// of 32 and 96.
    /// </summary>
    public Histogram BoxAreas { get; } = new(0, 8 * 8, 16 * 16, 32 * 32, 64 * 64, 96 * 96, 128 * 128, 256 * 256, 512 * 512);

    /// <summary>Labels by truncated fraction.</summary>
    public Histogram TruncatedFractions { get; } = Histogram.Fractions(FractionBins);

    /// <summary>Labels by occluded fraction, if known.</summary>
    public Histogram OccludedFractions { get; } = Histogram.Fractions(FractionBins);

    /// <summary>Counts a further frame.</summary>
    /// <exception cref="DatasetFormatException">There are too many kinds of weather.</exception>
    internal void Add(FrameLabel label)
    {
        FirstTimeSeconds = Frames == 0 ? label.TimeSeconds : FirstTimeSeconds;
        LastTimeSeconds = label.TimeSeconds;
        Frames++;
        if (_framesOfWeathers.Count > MaxWeathers)
        {
            throw new DatasetFormatException($"the labels name more than {MaxWeathers} kinds of weather; the game has 15.");
        }

        _framesOfWeathers[label.Environment.Weather] = _framesOfWeathers.GetValueOrDefault(label.Environment.Weather) + 1;
        _framesOfHours[label.Environment.TimeOfDay.Hours] = _framesOfHours.GetValueOrDefault(label.Environment.TimeOfDay.Hours) + 1;
        if (label.Events is { } open)
        {
            Events = _events;
            foreach (EventMark mark in open.Where(mark => !_open.Contains(mark)))
            {
                _events[mark.Kind] = _events.GetValueOrDefault(mark.Kind) + 1;
            }

            _open = [.. open];
        }

        if (label.Lanes is { } lanes)
        {
            Add(lanes.Indicators);
            Lanes.Add(lanes);
            LaneSources.Add(lanes);
        }

        foreach (ObjectLabel item in label.Objects)
        {
            if (!_classes.TryGetValue(item.Class, out ClassStatistics? kind))
            {
                kind = new ClassStatistics();
                _classes.Add(item.Class, kind);
            }

            kind.Add(item, _session);
            Distances.Add(item.DistanceMetres);
            BoxHeights.Add(item.Box2D.Height);
            SmallLabels += item.Box2D.Height < SmallPixels ? 1 : 0;
            BoxWidths.Add(item.Box2D.Width);
            BoxAreas.Add(item.Box2D.Area);
            TruncatedFractions.Add(item.TruncatedFraction);
            if (item.OccludedFraction is { } occluded)
            {
                OccludedFractions.Add(occluded);
            }
        }
    }

    private void Add(LaneIndicators indicators)
    {
        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            if (indicator.Of(indicators) is { IsValid: true, Value: double value })
            {
                _indicators[indicator.Name] = _indicators.GetValueOrDefault(indicator.Name).With(value);
            }
        }
    }
}
