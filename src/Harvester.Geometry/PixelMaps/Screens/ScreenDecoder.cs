using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>Decodes an instance map from the pictures of a <see cref="ScreenPlan"/>, in steps of one object or one row.</summary>
public sealed class ScreenDecoder : IMaskDecoder
{
    internal static Action<Camera, IReadOnlyList<MapTarget>, ScreenPlan, IReadOnlyList<byte[]>>? Tap;
    /// <summary>A colour that differs by more than this, squared grey levels, is another.</summary>
    private const int ClearDifference = 300;

    private readonly Camera _camera;
    private readonly IReadOnlyList<MapTarget> _targets;
    private readonly ScreenPlan _plan;
    private readonly IReadOnlyList<byte[]> _pictures;
    internal ScreenMatte[] Mattes => _mattes;
    private readonly ScreenMatte[] _mattes;
    private readonly IEnumerator<bool> _work;
    private readonly Dictionary<(int, int), int> _votes = [];
    private CodedMask? _result;

    /// <summary>Prepares to decode pictures.</summary>
    /// <param name="camera">The camera of the pictures.</param>
    /// <param name="targets">The targets of the plan.</param>
    /// <param name="plan">The plan by which the pictures were taken.</param>
    /// <param name="pictures">The pictures in the order of the plan: red, green and blue of each pixel, rows from the top.</param>
    /// <exception cref="ArgumentException">The number or size of the pictures does not match.</exception>
    public ScreenDecoder(Camera camera, IReadOnlyList<MapTarget> targets, ScreenPlan plan, IReadOnlyList<byte[]> pictures)
    {
        _camera = Guard.NotNull(camera, nameof(camera));
        _targets = Guard.NotNull(targets, nameof(targets));
        _plan = Guard.NotNull(plan, nameof(plan));
        _pictures = Guard.NotNull(pictures, nameof(pictures));
        if (pictures.Count != plan.PictureCount || pictures.Any(picture => picture.Length != 3 * camera.Image.PixelCount))
        {
            throw new ArgumentException("The pictures do not match the plan or the size of the image.", nameof(pictures));
        }

        Tap?.Invoke(camera, targets, plan, pictures);
        _mattes = new ScreenMatte[targets.Count];
        _work = Work().GetEnumerator();
    }

    /// <inheritdoc/>
    public bool Step() => _work.MoveNext();

    /// <inheritdoc/>
    public CodedMask Finish()
    {
        while (Step())
        {
        }

        return _result!;
    }

    private IEnumerable<bool> Work()
    {
        double darkest = DarkestShadow();
        Console.Error.WriteLine($"darkest {darkest:F2}");
        for (int i = 0; i < _mattes.Length; i++)
        {
            int target = i;
            _mattes[i] = new ScreenMatte(
                _plan.Screens[i].Spans, _camera.Image.Width, _pictures[1], PictureOf(_plan.ShownPicture(i), i),
                PictureOf(_plan.EmptyPicture(i), i), darkest, (column, row) => IsGround(target, column, row));
            yield return true;
        }

        var map = new InstanceMap(_camera.Image);
        var undetermined = new PixelMap(_camera.Image);
        var amodal = new Dictionary<ushort, PixelMap>();
        foreach (MapTarget target in _targets)
        {
            amodal[target.Number] = new PixelMap(_camera.Image);
        }

        List<(int Column, int Row, int[] There)> several = [];
        List<int> there = [];
        for (int row = 0; row < _camera.Image.Height; row++)
        {
            for (int column = 0; column < _camera.Image.Width; column++)
            {
                there.Clear();
                for (int i = 0; i < _mattes.Length; i++)
                {
                    if (_mattes[i].StateAt(column, row) == MatteState.Object)
                    {
                        there.Add(i);
                        amodal[_targets[i].Number][column, row] = true;
                    }
                }

                if (there.Count == 1)
                {
                    map[column, row] = _targets[there[0]].Number;
                }
                else if (there.Count > 1)
                {
                    several.Add((column, row, [.. there]));
                    Vote(there, column, row);
                }
            }

            yield return true;
        }

        foreach ((int column, int row, int[] those) in several)
        {
            map[column, row] = _targets[FrontOf([.. those], column, row)].Number;
        }

        _result = new CodedMask(map, undetermined, amodal);
    }

    private ScreenPicture? PictureOf(int number, int target) => number == 0 ? null
        : new ScreenPicture(_pictures[number], [.. _plan.Nearer(number, target).Select(other => _plan.Screens[other].Spans)]);

    private int FrontOf(List<int> there, int column, int row)
    {
        int front = there[0];
        for (int i = 1; i < there.Count; i++)
        {
            front = IsBefore(there[i], front, column, row) ? there[i] : front;
        }

        return front;
    }

    /// <summary>
    /// Whether an object is in front of another: if the line of sight leaves the cuboid of one before it enters that of the other, that
    /// one; otherwise the one whose colour is seen in the picture with all objects, here or in most places that both cover.
    /// </summary>
    private bool IsBefore(int a, int b, int column, int row)
    {
        if (IsBeforeByPlace(a, b, column, row) is { } before)
        {
            return before;
        }

        if (IsBeforeByColour(a, b, column, row) is { } seen)
        {
            return seen;
        }

        int votes = _votes.TryGetValue((a, b), out int forA) ? forA : 0;
        return votes != 0 ? votes > 0 : _plan.Screens[a].DistanceMetres < _plan.Screens[b].DistanceMetres;
    }

    private void Vote(List<int> there, int column, int row)
    {
        foreach (int a in there)
        {
            foreach (int b in there)
            {
                if (a < b && IsBeforeByPlace(a, b, column, row) is null && IsBeforeByColour(a, b, column, row) is { } before)
                {
                    int vote = before ? 1 : -1;
                    _votes[(a, b)] = (_votes.TryGetValue((a, b), out int sum) ? sum : 0) + vote;
                    _votes[(b, a)] = (_votes.TryGetValue((b, a), out int reverse) ? reverse : 0) - vote;
                }
            }
        }
    }

    private bool? IsBeforeByPlace(int a, int b, int column, int row)
    {
        Ray ray = _camera.RayThrough(column + 0.5, row + 0.5);
        if (SpanOf(a, ray) is not { } spanA || SpanOf(b, ray) is not { } spanB)
        {
            return null;
        }

        return spanA.Exit <= spanB.Entry || spanB.Exit <= spanA.Entry ? spanA.Entry < spanB.Entry : null;
    }

    private RaySpan? SpanOf(int target, Ray ray) => _targets[target].Cuboid.Intersect(ray) ?? _plan.Screens[target].Box.Intersect(ray);

    private bool? IsBeforeByColour(int a, int b, int column, int row)
    {
        if (!_mattes[a].IsPure(column, row) || !_mattes[b].IsPure(column, row))
        {
            return null;
        }

        int pixel = 3 * ((row * _camera.Image.Width) + column);
        (int ofA, int ofB) = (DifferenceFromAll(a, pixel), DifferenceFromAll(b, pixel));
        return Math.Max(ofA, ofB) > ClearDifference && Math.Max(ofA, ofB) > 4 * Math.Min(ofA, ofB) ? ofA < ofB : null;
    }

    private int DifferenceFromAll(int target, int first)
    {
        byte[] all = _pictures[0];
        byte[] alone = _pictures[_plan.ShownPicture(target)];
        int difference = 0;
        for (int i = first; i < first + 3; i++)
        {
            difference += (all[i] - alone[i]) * (all[i] - alone[i]);
        }

        return difference;
    }

    /// <summary>The fraction of the light that the full shadows of this frame leave: objects shade what is outside all screens.</summary>
    private double DarkestShadow()
    {
        List<double> left = [];
        for (int row = 0; row < _camera.Image.Height; row += 2)
        {
            for (int column = 0; column < _camera.Image.Width; column += 2)
            {
                int pixel = 3 * ((row * _camera.Image.Width) + column);
                int lit = _pictures[1][pixel] + _pictures[1][pixel + 1] + _pictures[1][pixel + 2];
                int now = _pictures[0][pixel] + _pictures[0][pixel + 1] + _pictures[0][pixel + 2];
                if (lit > 90 && now < 0.9 * lit && !_plan.Screens.Any(screen => screen.Spans.Contains(column, row)))
                {
                    left.Add((double)now / lit);
                }
            }
        }

        left.Sort();
        return left.Count > 20 ? 0.9 * left[left.Count / 10] : 0.12;
    }

    private bool IsGround(int target, int column, int row)
    {
        Cuboid box = _plan.Screens[target].Box;
        Ray ray = _camera.RayThrough(column + 0.5, row + 0.5);
        Vector3D up = box.Axes.Up;
        return box.Intersect(ray) is not { } span
            || (ray.Origin + (ray.Direction * span.Exit) - box.Centre).Dot(up) + box.HalfExtents.Z < 0.15;
    }
}
