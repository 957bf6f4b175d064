using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Datasets.Exports.Formats.Kitti;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Statistics;

/// <summary>Figures of a whole session, gathered in one pass over its labels.</summary>
public sealed class SessionStatistics
{
    private const double FarMetres = 150;
    private const int DistanceBins = 15;
    private const double LargeSidePixels = 400;
    private const int SideBins = 20;
    private const int FractionBins = 10;

    private readonly SortedDictionary<ObjectClass, ClassStatistics> _classes = [];
    private readonly SortedDictionary<string, int> _framesOfWeathers = new(StringComparer.Ordinal);
    private readonly SortedDictionary<int, int> _framesOfHours = [];
    private readonly SortedDictionary<string, IndicatorSpan> _indicators = new(StringComparer.Ordinal);
    private int _session;

    /// <summary>Gathers the figures of one session.</summary>
    public static SessionStatistics Of(IEnumerable<FrameLabel> labels) => Of([labels]);

    /// <summary>Gathers the figures of several sessions, whose objects are different ones even where their ids are the same.</summary>
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
        }

        return statistics;
    }

    /// <summary>Frames.</summary>
    public int Frames { get; private set; }

    /// <summary>Labels of all classes.</summary>
    public int Labels => _classes.Values.Sum(kind => kind.Labels);

    /// <summary>Labels a frame; 0 without frames.</summary>
    public double LabelsPerFrame => Frames == 0 ? 0 : (double)Labels / Frames;

    /// <summary>
    /// Labels of what KITTI labels too: vehicles, people and other things that move, not signs and lights with their faces and heads.
    /// </summary>
    public int LabelsAsKitti => _classes.Where(kind => KittiClasses.Has(kind.Key)).Sum(kind => kind.Value.Labels);

    /// <summary>The same a frame; 0 without frames.</summary>
    public double LabelsAsKittiPerFrame => Frames == 0 ? 0 : (double)LabelsAsKitti / Frames;

    /// <summary>Figures by class, in the order of the classes; only those that occur.</summary>
    public IReadOnlyDictionary<ObjectClass, ClassStatistics> Classes => _classes;

    /// <summary>The weathers that occur, in the order of the letters.</summary>
    public IReadOnlyCollection<string> Weathers => _framesOfWeathers.Keys;

    /// <summary>How many frames have each weather, in the order of the letters.</summary>
    public IReadOnlyDictionary<string, int> FramesOfWeathers => _framesOfWeathers;

    /// <summary>How many frames have each hour of the day, 0 to 23; only those that occur.</summary>
    public IReadOnlyDictionary<int, int> FramesOfHours => _framesOfHours;

    /// <summary>Between what values the lane indicators were; only those that were valid in some frame.</summary>
    public IReadOnlyDictionary<string, IndicatorSpan> Indicators => _indicators;

    /// <summary>The game's time of the first frame, seconds.</summary>
    public double FirstTimeSeconds { get; private set; }

    /// <summary>The game's time of the last frame, seconds.</summary>
    public double LastTimeSeconds { get; private set; }

    /// <summary>Labels by distance, metres.</summary>
    public Histogram Distances { get; } = Histogram.Even(FarMetres, DistanceBins);

    /// <summary>Labels by height of the box in the image, pixels.</summary>
    public Histogram BoxHeights { get; } = Histogram.Even(LargeSidePixels, SideBins);

    /// <summary>Labels by width of the box in the image, pixels.</summary>
    public Histogram BoxWidths { get; } = Histogram.Even(LargeSidePixels, SideBins);

    /// <summary>
    /// Labels by area of the box in the image, square pixels: from squares of 8 to 512 pixels a side, COCO's limits of 32 and 96 among
    /// them.
    /// </summary>
    public Histogram BoxAreas { get; } = new(0, 8 * 8, 16 * 16, 32 * 32, 64 * 64, 96 * 96, 128 * 128, 256 * 256, 512 * 512);

    /// <summary>Labels by truncated fraction.</summary>
    public Histogram TruncatedFractions { get; } = Histogram.Fractions(FractionBins);

    /// <summary>Labels by occluded fraction, where it was determined.</summary>
    public Histogram OccludedFractions { get; } = Histogram.Fractions(FractionBins);

    private void Add(FrameLabel label)
    {
        FirstTimeSeconds = Frames == 0 ? label.TimeSeconds : FirstTimeSeconds;
        LastTimeSeconds = label.TimeSeconds;
        Frames++;
        _framesOfWeathers[label.Environment.Weather] = _framesOfWeathers.GetValueOrDefault(label.Environment.Weather) + 1;
        _framesOfHours[label.Environment.TimeOfDay.Hours] = _framesOfHours.GetValueOrDefault(label.Environment.TimeOfDay.Hours) + 1;
        if (label.Lanes is { } lanes)
        {
            Add(lanes.Indicators);
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
