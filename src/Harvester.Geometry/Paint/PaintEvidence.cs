namespace Harvester.Geometry.Paint;

/// <summary>What images show of the links of a network, row by row.</summary>
public sealed class PaintEvidence
{
    /// <summary>
    /// Images of a row that are kept: enough for a median to a fifth of a single image's error, few enough for a whole map in memory.
    /// </summary>
    private const int MaxImagesPerRow = 32;

    private readonly SortedDictionary<int, SortedDictionary<int, PaintRow>> _links = [];

    /// <summary>The links that were seen, in ascending order.</summary>
    public IEnumerable<int> Links => _links.Keys;

    /// <summary>What was seen of stop lines and crossings.</summary>
    internal MarkEvidence Marks { get; } = new();

    /// <summary>Whether nothing was seen.</summary>
    public bool IsEmpty => _links.Count == 0;

    /// <summary>The row of a link; null if it was not seen.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="row">Number of the row.</param>
    public PaintRow? RowOf(int link, int row) =>
        _links.TryGetValue(link, out SortedDictionary<int, PaintRow>? rows) && rows.TryGetValue(row, out PaintRow? found) ? found : null;

    /// <summary>Adds a part of a row that was seen.</summary>
    public void Add(int link, int row, SeenSpan seen) => RowFor(link, row).Seen.Add(seen);

    /// <summary>Adds a stripe.</summary>
    public void Add(int link, int row, PaintCandidate candidate) => RowFor(link, row).Candidates.Add(candidate);

    /// <summary>Adds what other images show; of a row that was seen in many images, the first ones are kept.</summary>
    public void Add(PaintEvidence other)
    {
        Marks.Add(Guard.NotNull(other, nameof(other)).Marks);
        foreach (KeyValuePair<int, SortedDictionary<int, PaintRow>> link in other._links)
        {
            foreach (KeyValuePair<int, PaintRow> row in link.Value)
            {
                PaintRow own = RowFor(link.Key, row.Key);
                if (own.Images < MaxImagesPerRow)
                {
                    own.Seen.AddRange(row.Value.Seen);
                    own.Candidates.AddRange(row.Value.Candidates);
                    own.Images++;
                }
            }
        }
    }

    private PaintRow RowFor(int link, int row)
    {
        if (!_links.TryGetValue(link, out SortedDictionary<int, PaintRow>? rows))
        {
            _links.Add(link, rows = []);
        }

        if (!rows.TryGetValue(row, out PaintRow? found))
        {
            rows.Add(row, found = new PaintRow());
        }

        return found;
    }
}
