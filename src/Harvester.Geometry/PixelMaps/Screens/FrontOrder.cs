using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Which of several objects is in front at a pixel. If the line of sight leaves the cuboid of one before it enters that of another, the
/// first is in front of the second. Otherwise it is the one whose colour is seen in the picture with all objects, at this pixel, at most
/// pixels around it, or at most pixels that both cover. A rider and a motorcycle are each in front of the other somewhere.
/// </summary>
internal sealed class FrontOrder(
    Camera camera,
    IReadOnlyList<MapTarget> targets,
    ScreenPlan plan,
    IReadOnlyList<byte[]> pictures,
    ScreenMatte[] mattes
)
{
    /// <summary>A colour that differs by more than this, squared grey levels, is another: far more than noise.</summary>
    private const int ClearSquares = 100;

    /// <summary>And it must differ by this many times more than the other object's, squared.</summary>
    private const int ClearRatio = 4;

    /// <summary>Pixels around a pixel without a clear colour that decide for it: half the side of the greatest square, pixels.</summary>
    private const int MaxReach = 8;

    private readonly Dictionary<(int, int), int> _votes = [];
    private readonly Dictionary<(int A, int B, int Pixel), bool> _clear = [];

    /// <summary>Takes the votes of a pixel.</summary>
    /// <param name="there">The objects that cover it, in ascending order.</param>
    /// <param name="column">Its column.</param>
    /// <param name="row">Its row.</param>
    public void Vote(List<int> there, int column, int row)
    {
        for (int i = 0; i < there.Count; i++)
        {
            for (int j = i + 1; j < there.Count; j++)
            {
                (int a, int b) = (there[i], there[j]);

                // Only pixels that geometry leaves open vote, and only those whose colour is clear.
                if (ByPlace(a, b, column, row) is null && ByColour(a, b, column, row) is { } isBefore)
                {
                    _votes[(a, b)] = (_votes.TryGetValue((a, b), out int sum) ? sum : 0) + (isBefore ? 1 : -1);
                    _clear[(a, b, (row * camera.Image.Width) + column)] = isBefore;
                }
            }
        }
    }

    /// <summary>The object in front at a pixel, after all votes.</summary>
    public int FrontOf(List<int> there, int column, int row)
    {
        int front = there[0];
        for (int i = 1; i < there.Count; i++)
        {
            front = IsBefore(front, there[i], column, row) ? front : there[i];
        }

        return front;
    }

    private bool IsBefore(int a, int b, int column, int row)
    {
        if ((ByPlace(a, b, column, row) ?? ByColour(a, b, column, row)) is { } known)
        {
            return known;
        }

        (int first, int second) = (Math.Min(a, b), Math.Max(a, b));

        // Around the pixel first, then anywhere; without a vote the nearer centre is in front.
        int votes =
            !_votes.TryGetValue((first, second), out int sum) ? 0
            : VotesAround(first, second, column, row) is var near and not 0 ? near
            : sum;
        return votes != 0 ? votes > 0 == a < b : plan.Screens[a].DistanceMetres <= plan.Screens[b].DistanceMetres;
    }

    /// <summary>The votes of the pixels around one: those of the smallest square about it in which one side has more; 0 for none.</summary>
    private int VotesAround(int a, int b, int column, int row)
    {
        int sum = 0;
        for (int reach = 1; reach <= MaxReach && sum == 0; reach++)
        {
            for (int y = Math.Max(0, row - reach); y <= Math.Min(camera.Image.Height - 1, row + reach); y++)
            {
                for (int x = Math.Max(0, column - reach); x <= Math.Min(camera.Image.Width - 1, column + reach); x++)
                {
                    sum += _clear.TryGetValue((a, b, (y * camera.Image.Width) + x), out bool isBefore) ? (isBefore ? 1 : -1) : 0;
                }
            }
        }

        return sum;
    }

    private bool? ByPlace(int a, int b, int column, int row)
    {
        Ray ray = camera.RayThrough(column + 0.5, row + 0.5);
        return SpanOf(a, ray) is { } ofA && SpanOf(b, ray) is { } ofB && (ofA.Exit <= ofB.Entry || ofB.Exit <= ofA.Entry)
            ? ofA.Entry < ofB.Entry
            : null;
    }

    private RaySpan? SpanOf(int target, Ray ray) => targets[target].Cuboid.Intersect(ray) ?? plan.Screens[target].Box.Intersect(ray);

    private bool? ByColour(int a, int b, int column, int row)
    {
        if (!mattes[a].IsPure(column, row) || !mattes[b].IsPure(column, row))
        {
            return null;
        }

        int first = 3 * ((row * camera.Image.Width) + column);

        // The object in front has in the picture with all objects the colour that it has before its own screen.
        (int ofA, int ofB) = (SquaresFromAll(a, first), SquaresFromAll(b, first));

        // One colour must be clearly another, and the squared difference four times the other's: twice as far.
        return Math.Max(ofA, ofB) > Math.Max(ClearSquares, ClearRatio * Math.Min(ofA, ofB)) ? ofA < ofB : null;
    }

    private int SquaresFromAll(int target, int first)
    {
        byte[] all = pictures[0];
        byte[] alone = pictures[plan.ShownPicture(target)];
        int squares = 0;
        for (int i = first; i < first + 3; i++)
        {
            squares += (all[i] - alone[i]) * (all[i] - alone[i]);
        }

        return squares;
    }
}
