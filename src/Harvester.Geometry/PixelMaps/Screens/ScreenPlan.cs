using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// What each picture of a mask shows. Picture 0 shows all objects, picture 1 none. Each of the others shows some objects, each before a
/// screen, and screens of other objects that are hidden. Every object is photographed once before its screen and once hidden, so that what
/// else is in front of its screen is known. Screens of one picture do not overlap in the image as far as there are pictures for that;
/// where they must, the nearer object is not harmed, as its screen lies in front.
/// </summary>
public sealed class ScreenPlan : IPicturePlan
{
    /// <summary>The greatest number of pictures.</summary>
    public const int MaxPictures = 17;

    private const int FirstScreened = 2;

    /// <summary>An object before its screen matters more than the screen without it.</summary>
    private const double ShownWeight = 4;

    private readonly Camera _camera;
    private readonly IReadOnlyList<MapTarget> _targets;
    private readonly ObjectScreen[] _screens;
    private readonly double[,] _harm;
    private readonly List<List<int>> _shown = [];
    private readonly List<List<int>> _empty = [];

    private ScreenPlan(Camera camera, IReadOnlyList<MapTarget> targets)
    {
        _camera = camera;
        _targets = targets;
        ObjectScreen[] screens = [.. targets.Select(target => ObjectScreen.Of(camera, target))];
        _screens = screens;
        _harm = new double[screens.Length, screens.Length];
        var degrees = new int[screens.Length];
        for (int i = 0; i < screens.Length; i++)
        {
            for (int j = i + 1; j < screens.Length; j++)
            {
                int shared = screens[i].PixelsSharedWith(screens[j]);
                int farther = IsNearer(i, j) ? j : i;
                _harm[i, j] = _harm[j, i] = (double)shared / Math.Max(1, screens[farther].Spans.PixelCount);
                degrees[i] += shared > 0 ? 1 : 0;
                degrees[j] += shared > 0 ? 1 : 0;
            }
        }

        int[] order = [.. Enumerable.Range(0, screens.Length).Where(index => screens[index].Spans.PixelCount > 0)
            .OrderByDescending(index => degrees[index]).ThenBy(index => screens[index].DistanceMetres).ThenBy(static index => index)];
        foreach (int index in order)
        {
            Place(index, _shown);
        }

        foreach (int index in order)
        {
            Place(index, _empty);
        }
    }

    /// <inheritdoc/>
    public int PictureCount => FirstScreened + _shown.Count;

    internal IReadOnlyList<ObjectScreen> Screens => _screens;

    /// <summary>Makes a plan.</summary>
    /// <param name="camera">The camera of the pictures.</param>
    /// <param name="targets">The objects that can be hidden.</param>
    public static ScreenPlan For(Camera camera, IReadOnlyList<MapTarget> targets)
        => new(Guard.NotNull(camera, nameof(camera)), Guard.NotNull(targets, nameof(targets)));

    /// <inheritdoc/>
    public bool IsShown(int picture, int target) =>
        picture == 0 || (picture >= FirstScreened && _shown[picture - FirstScreened].Contains(target));

    /// <summary>Whether a picture has a target's screen.</summary>
    /// <param name="picture">Number of the picture, from 0.</param>
    /// <param name="target">Index of the target, from 0.</param>
    public bool HasScreen(int picture, int target) => picture >= FirstScreened
        && (_shown[picture - FirstScreened].Contains(target) || _empty[picture - FirstScreened].Contains(target));

    /// <inheritdoc/>
    public IReadOnlyList<ScreenSheet> Sheets(int picture) => picture < FirstScreened ? []
        : [.. _shown[picture - FirstScreened].Concat(_empty[picture - FirstScreened])
            .SelectMany(index => _screens[index].Sheets(_camera.Pose.Position))];

    /// <inheritdoc/>
    public IMaskDecoder Decoder(IReadOnlyList<byte[]> pictures) => new ScreenDecoder(_camera, _targets, this, pictures);

    /// <summary>The picture with a target before its screen; 0 if there is none.</summary>
    internal int ShownPicture(int target) => NumberOf(_shown, target);

    /// <summary>The picture with a target's screen without it; 0 if there is none.</summary>
    internal int EmptyPicture(int target) => NumberOf(_empty, target);

    /// <summary>The nearer targets whose screens may hide that of a target in a picture.</summary>
    internal IReadOnlyList<int> Nearer(int picture, int target) =>
        [.. _shown[picture - FirstScreened].Concat(_empty[picture - FirstScreened])
            .Where(other => other != target && _harm[other, target] > 0 && IsNearer(other, target))];

    private static int NumberOf(List<List<int>> pictures, int target)
    {
        int index = pictures.FindIndex(targets => targets.Contains(target));
        return index < 0 ? 0 : index + FirstScreened;
    }

    private bool IsNearer(int a, int b) =>
        _screens[a].DistanceMetres < _screens[b].DistanceMetres || (_screens[a].DistanceMetres == _screens[b].DistanceMetres && a < b);

    private void Place(int index, List<List<int>> slots)
    {
        (int best, double least) = (-1, double.PositiveInfinity);
        for (int number = 0; number < _shown.Count && least > 0; number++)
        {
            if (!_shown[number].Contains(index) && HarmIn(number, index) is var harm && harm < least)
            {
                (best, least) = (number, harm);
            }
        }

        if (least > 0 && PictureCount < MaxPictures)
        {
            best = _shown.Count;
            _shown.Add([]);
            _empty.Add([]);
        }

        if (best >= 0)
        {
            slots[best].Add(index);
        }
    }

    /// <summary>How much of the objects would be lost if another were added to a picture.</summary>
    private double HarmIn(int number, int index) =>
        (ShownWeight * _shown[number].Sum(other => _harm[other, index])) + _empty[number].Sum(other => _harm[other, index]);
}
