using Harvester.Geometry;
using Harvester.Sessions.Plans;

namespace Harvester.Play.Surveys.Paint;

/// <summary>The places of a plan for the survey of paint.</summary>
public static class PlannedPlaces
{
    /// <summary>
    /// The places of a plan: where its drives begin, and the points of their paths. Places that the plan leaves to be chosen (spread, or
    /// before a space of interest) are not among them.
    /// </summary>
    /// <param name="file">The plan file; null if none is set.</param>
    /// <exception cref="IOException">The file is missing or cannot be read; the message is for the player.</exception>
    /// <exception cref="FormatException">The plan has a problem, or names no such place; the message is for the player.</exception>
    public static IReadOnlyList<Vector2D> In(string? file)
    {
        if (file is null)
        {
            throw new FileNotFoundException("Around = Plan under [PaintSurvey] needs a plan: name one as File under [Plan].");
        }

        PlanReading reading = PlanParser.Read(PlanResults.ReadText(file));
        string name = Path.GetFileName(file);
        Plan plan = reading.Plan ?? throw new FormatException($"{name}: {reading.Problems[0]}");
        Vector2D[] places = [.. plan.Places.SelectMany(PointsOf)];
        return places.Length > 0
            ? places
            : throw new FormatException($"{name} has no place with a point or a path; it chooses all its places when it runs.");
    }

    private static IEnumerable<Vector2D> PointsOf(PlanPlace place) =>
        place.Path.Count > 0 ? place.Path
        : place.Point is { } point ? [point]
        : [];
}
