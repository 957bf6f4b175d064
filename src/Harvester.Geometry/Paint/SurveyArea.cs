using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>Where the roads of a survey of paint lie: around one place or several.</summary>
public sealed class SurveyArea
{
    private readonly double _range;

    /// <summary>Creates an area.</summary>
    /// <param name="places">The places, at least one, metres, world; the survey begins at the first.</param>
    /// <param name="rangeMetres">Roads farther than this from all of them are left out, metres; greater than 0.</param>
    /// <exception cref="ArgumentException">There is no place.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The range is not greater than 0.</exception>
    public SurveyArea(IReadOnlyList<Vector2D> places, double rangeMetres)
    {
        Places =
            Guard.NotNull(places, nameof(places)).Count > 0 ? places : throw new ArgumentException("There is no place.", nameof(places));
        _range =
            rangeMetres > 0
                ? rangeMetres
                : throw new ArgumentOutOfRangeException(nameof(rangeMetres), rangeMetres, "It must be greater than 0.");
    }

    /// <summary>The places, metres, world.</summary>
    public IReadOnlyList<Vector2D> Places { get; }

    /// <summary>Whether a point lies in the area.</summary>
    internal bool Contains(Vector3D point)
    {
        var place = new Vector2D(point.X, point.Y);
        return Places.Any(middle => (place - middle).Length <= _range);
    }

    /// <summary>Whether a road may reach into the area.</summary>
    internal bool MayHave(RoadCurve road) => Places.Any(middle => !road.IsBeyond(middle, _range));
}
