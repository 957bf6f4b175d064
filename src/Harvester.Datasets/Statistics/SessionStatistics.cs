using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;

namespace Harvester.Datasets.Statistics;

/// <summary>Figures of a whole session, gathered in one pass over its labels.</summary>
public sealed class SessionStatistics
{
    private const double DistanceBinMetres = 10;
    private const int DistanceBins = 15;
    private const double OcclusionBin = 0.1;
    private const int OcclusionBins = 10;

    private readonly SortedDictionary<ObjectClass, ClassStatistics> _classes = [];
    private readonly SortedSet<string> _weathers = [];

    /// <summary>Gathers the figures.</summary>
    public static SessionStatistics Of(IEnumerable<FrameLabel> labels)
    {
        var statistics = new SessionStatistics();
        foreach (FrameLabel label in labels)
        {
            statistics.Add(label);
        }

        return statistics;
    }

    /// <summary>Frames.</summary>
    public int Frames { get; private set; }

    /// <summary>Labels of all classes.</summary>
    public int Labels => _classes.Values.Sum(kind => kind.Labels);

    /// <summary>Figures by class, in the order of the classes; only those that occur.</summary>
    public IReadOnlyDictionary<ObjectClass, ClassStatistics> Classes => _classes;

    /// <summary>The weathers that occur, in the order of the letters.</summary>
    public IReadOnlyCollection<string> Weathers => _weathers;

    /// <summary>The game's time of the first frame, seconds.</summary>
    public double FirstTimeSeconds { get; private set; }

    /// <summary>The game's time of the last frame, seconds.</summary>
    public double LastTimeSeconds { get; private set; }

    /// <summary>Labels by distance, metres.</summary>
    public Histogram Distances { get; } = new(DistanceBinMetres, DistanceBins);

    /// <summary>Labels by occluded fraction, where it was determined.</summary>
    public Histogram OccludedFractions { get; } = new(OcclusionBin, OcclusionBins);

    private void Add(FrameLabel label)
    {
        FirstTimeSeconds = Frames == 0 ? label.TimeSeconds : FirstTimeSeconds;
        LastTimeSeconds = label.TimeSeconds;
        Frames++;
        _weathers.Add(label.Environment.Weather);
        foreach (ObjectLabel item in label.Objects)
        {
            if (!_classes.TryGetValue(item.Class, out ClassStatistics? kind))
            {
                kind = new ClassStatistics();
                _classes.Add(item.Class, kind);
            }

            kind.Add(item);
            Distances.Add(item.DistanceMetres);
            if (item.OccludedFraction is { } occluded)
            {
                OccludedFractions.Add(occluded);
            }
        }
    }
}
