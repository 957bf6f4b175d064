using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>The paint measured on the links of a road network. Immutable, and so safe for any number of threads.</summary>
public sealed class PaintTable
{
    private readonly Dictionary<int, LinkPaint> _links;

    /// <summary>Creates a table.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="links">The links that were seen, each once.</param>
    /// <param name="absentLinks">Number of links that the file has and the network does not; 0 or more.</param>
    /// <exception cref="ArgumentException">A link does not exist or is listed twice.</exception>
    public PaintTable(RoadNetwork network, IEnumerable<LinkPaint> links, int absentLinks = 0)
    {
        Network = Guard.NotNull(network, nameof(network));
        AbsentLinks = Guard.AtLeast(absentLinks, 0, nameof(absentLinks));
        _links = [];
        foreach (LinkPaint link in Guard.NotNull(links, nameof(links)))
        {
            if (link.Link < 0 || link.Link >= network.Links.Count || _links.ContainsKey(link.Link))
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"Link {link.Link} does not exist or is listed twice."),
                    nameof(links)
                );
            }

            _links.Add(link.Link, link);
        }

        Links = [.. _links.Values.OrderBy(link => link.Link)];
    }

    /// <summary>The roads to which the links belong.</summary>
    public RoadNetwork Network { get; }

    /// <summary>The links that were seen, by their index.</summary>
    public IReadOnlyList<LinkPaint> Links { get; }

    /// <summary>The stop lines and crossings; empty if none was found.</summary>
    public IReadOnlyList<MarkPaint> Marks { get; init; } = [];

    /// <summary>
    /// Number of links that the file has and the network does not. A table of the whole map is read with the network of a part of it.
    /// </summary>
    public int AbsentLinks { get; }

    /// <summary>The paint of a link; null if the link was not seen.</summary>
    /// <param name="link">Index of the link.</param>
    public LinkPaint? Of(int link) => _links.TryGetValue(link, out LinkPaint? paint) ? paint : null;
}
