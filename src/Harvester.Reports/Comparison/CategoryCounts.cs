using Harvester.Sessions.Reading.Files;

namespace Harvester.Reports.Comparison;

/// <summary>How often each of a few names occurs.</summary>
public sealed class CategoryCounts
{
    private const int MaxNames = 1000;

    private readonly SortedDictionary<string, long> _counts = new(StringComparer.Ordinal);

    /// <summary>Count of all.</summary>
    public long Count { get; private set; }

    /// <summary>The names that occur, in ordinal order.</summary>
    public IEnumerable<string> Names => _counts.Keys;

    /// <summary>How often a name occurs.</summary>
    public long Of(string name) => _counts.GetValueOrDefault(name);

    /// <summary>The fraction of all that have a name, 0 to 1; 0 if there are none.</summary>
    public double FractionOf(string name) => Count == 0 ? 0 : (double)Of(name) / Count;

    /// <summary>Counts a name.</summary>
    /// <exception cref="DatasetFormatException">There are too many names.</exception>
    public void Add(string name)
    {
        _counts[name] = Of(name) + 1;
        Count++;
        if (_counts.Count > MaxNames)
        {
            throw new DatasetFormatException($"the dataset has more than {MaxNames} classes, the limit.");
        }
    }
}
