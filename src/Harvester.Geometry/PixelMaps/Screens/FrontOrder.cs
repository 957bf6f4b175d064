using System;
using System.Collections.Generic;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Which of several objects is in front at a pixel. If the line of sight leaves the cuboid of one before it enters that of another, the
/// first is in front of the second. Otherwise it is the one whose colour is seen in the picture with all objects, at this pixel or at most
/// pixels that both cover.
/// </summary>
internal sealed class FrontOrder(
    Camera camera, IReadOnlyList<MapTarget> targets, ScreenPlan plan, IReadOnlyList<byte[]> pictures, ScreenMatte[] mattes)
{
    /// <summary>A colour that differs by more than this, squared grey levels, is another: far more than noise.</summary>
    private const int ClearSquares = 300;

    /// <summary>And it must differ by so many times more than the other object's, squared.</summary>
    private const int ClearRatio = 4;

    private readonly Dictionary<(int, int), int> _votes = [];

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
                if (ByPlace(a, b, column, row) is null && ByColour(a, b, column, row) is { } isBefore)
                {
                    _votes[(a, b)] = (_votes.TryGetValue((a, b), out int sum) ? sum : 0) + (isBefore ? 1 : -1);
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

        int votes = _votes.TryGetValue((Math.Min(a, b), Math.Max(a, b)), out int sum) ? sum : 0;
        return votes != 0 ? votes > 0 == a < b : plan.Screens[a].DistanceMetres <= plan.Screens[b].DistanceMetres;
    }

    private bool? ByPlace(int a, int b, int column, int row)
    {
        Ray ray = camera.RayThrough(column + 0.5, row + 0.5);
        return SpanOf(a, ray) is { } ofA && SpanOf(b, ray) is { } ofB && (ofA.Exit <= ofB.Entry || ofB.Exit <= ofA.Entry)
            ? ofA.Entry < ofB.Entry : null;
    }

    private RaySpan? SpanOf(int target, Ray ray) => targets[target].Cuboid.Intersect(ray) ?? plan.Screens[target].Box.Intersect(ray);

    private bool? ByColour(int a, int b, int column, int row)
    {
        if (!mattes[a].IsPure(column, row) || !mattes[b].IsPure(column, row))
        {
            return null;
        }

        int first = 3 * ((row * camera.Image.Width) + column);
        (int ofA, int ofB) = (SquaresFromAll(a, first), SquaresFromAll(b, first));
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
