using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Statistics;

/// <summary>Statistics of one object class in a session.</summary>
public sealed class ClassStatistics
{
    private readonly HashSet<(int Session, int Id)> _ids = [];
    private readonly HashSet<(int Session, int Id)> _parts = [];
    private readonly QuantileSketch _distances = new();
    private double _occlusionSum;
    private int _occlusionCount;

    /// <summary>Number of labels: an object counts in each frame in which it is labelled.</summary>
    public int Labels => _distances.Count;

    /// <summary>Number of different objects.</summary>
    public int Objects => _ids.Count;

    /// <summary>Number of these that are parts of others: faces of signs, heads of traffic lights.</summary>
    public int Parts => _parts.Count;

    /// <summary>Distance of the nearest object, metres.</summary>
    public double MinMetres => _distances.Min;

    /// <summary>Median distance, metres, accurate to 1/4096 of its value; of an even number, the mean of the two middle values.</summary>
    public double MedianDistanceMetres => _distances.Median;

    /// <summary>Mean of the known occluded fractions; null if all are unknown.</summary>
    public double? MeanOccludedFraction => _occlusionCount == 0 ? null : _occlusionSum / _occlusionCount;

    internal void Add(ObjectLabel label, int session)
    {
        _ids.Add((session, label.Id));
        if (label.Parent is not null)
        {
            _parts.Add((session, label.Id));
        }

        _distances.Add(label.DistanceMetres);
        if (label.OccludedFraction is { } occluded)
        {
            _occlusionSum += occluded;
            _occlusionCount++;
        }
    }
}
