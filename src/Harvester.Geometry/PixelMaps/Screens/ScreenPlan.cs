using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Photographs each object before a screen of its own. Picture 0 shows all objects, picture 1 none. Each of the others shows some objects
/// before their screens, and screens of other objects, which are hidden; so what else is in front of each screen is known. As far as there
/// are pictures for that, the screens of one picture do not overlap in the image; where they must, the nearer object is not harmed, because
/// its screen is in front.
/// </summary>
public sealed class ScreenPlan : IPicturePlan
{
    /// <summary>The greatest number of pictures.</summary>
    public const int MaxPictures = 17;

    private const int FirstScreened = 2;

    /// <summary>Losing a part of an object before its screen is this many times worse than losing it of the screen only.</summary>
    private const double ShownWeight = 4;

    private readonly Camera _camera;
    private readonly IReadOnlyList<MapTarget> _targets;
    private readonly ObjectScreen[] _screens;
    private readonly double[,] _harm;
    private readonly List<List<int>> _shown = [];
    private readonly List<List<int>> _empty = [];

    private ScreenPlan(Camera camera, IReadOnlyList<MapTarget> targets)
    {
        (_camera, _targets) = (camera, targets);
        _screens = [.. targets.Select(target => ObjectScreen.Of(camera, target))];
        _harm = new double[_screens.Length, _screens.Length];
        var degrees = new int[_screens.Length];
        for (int i = 0; i < _screens.Length; i++)
        {
            for (int j = i + 1; j < _screens.Length; j++)
            {
                // The nearer screen hides part of the farther one: harm = shared pixels / pixels of the farther screen.
                int shared = _screens[i].PixelsSharedWith(_screens[j]);
                int farther = IsNearer(i, j) ? j : i;
                _harm[i, j] = _harm[j, i] = (double)shared / Math.Max(1, _screens[farther].Spans.PixelCount);
                degrees[i] += shared > 0 ? 1 : 0;
                degrees[j] += shared > 0 ? 1 : 0;
            }
        }

        // Those that overlap with most others are the hardest to place.
        int[] order =
        [
            .. Enumerable
                .Range(0, _screens.Length)
                .Where(index => _screens[index].Spans.PixelCount > 0)
                .OrderByDescending(index => degrees[index])
                .ThenBy(index => _screens[index].DistanceMetres)
                .ThenBy(static index => index),
        ];
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

    /// <summary>Distributes the targets over pictures so that their screens overlap as little as possible.</summary>
    /// <param name="camera">The camera of the pictures.</param>
    /// <param name="targets">The objects that can be hidden.</param>
    public static ScreenPlan For(Camera camera, IReadOnlyList<MapTarget> targets) =>
        new(Guard.NotNull(camera, nameof(camera)), Guard.NotNull(targets, nameof(targets)));

    /// <inheritdoc/>
    public bool IsShown(int picture, int target) =>
        picture == 0 || (picture >= FirstScreened && _shown[picture - FirstScreened].Contains(target));

    /// <inheritdoc/>
    public IReadOnlyList<ScreenSheet> Sheets(int picture) =>
        [.. ScreensOf(picture).SelectMany(index => _screens[index].Sheets(_camera.Pose.Position))];

    /// <inheritdoc/>
    public IMaskDecoder Decoder(IReadOnlyList<byte[]> pictures) => new ScreenDecoder(_camera, _targets, this, pictures);

    /// <summary>The picture with a target before its screen; 0 if there is none.</summary>
    internal int ShownPicture(int target) => NumberOf(_shown, target);

    /// <summary>The picture with a target's screen without it; 0 if there is none.</summary>
    internal int EmptyPicture(int target) => NumberOf(_empty, target);

    /// <summary>The targets whose screens a picture has.</summary>
    internal IEnumerable<int> ScreensOf(int picture) =>
        picture < FirstScreened ? [] : _shown[picture - FirstScreened].Concat(_empty[picture - FirstScreened]);

    /// <summary>The nearer targets whose screens may hide that of a target in a picture.</summary>
    internal IEnumerable<int> Nearer(int picture, int target) =>
        ScreensOf(picture).Where(other => other != target && _harm[other, target] > 0 && IsNearer(other, target));

    private static int NumberOf(List<List<int>> pictures, int target)
    {
        int index = pictures.FindIndex(targets => targets.Contains(target));
        return index < 0 ? 0 : index + FirstScreened;
    }

    private bool IsNearer(int a, int b)
    {
        (double ofA, double ofB) = (_screens[a].DistanceMetres, _screens[b].DistanceMetres);
        return ofA < ofB || (ofA.Equals(ofB) && a < b);
    }

    /// <summary>Adds a target to the first picture without harm, to a new one, or to the one with the least harm.</summary>
    private void Place(int index, List<List<int>> kind)
    {
        (int best, double least) = (-1, double.PositiveInfinity);
        for (int number = 0; number < _shown.Count && least > 0; number++)
        {
            if (!_shown[number].Contains(index) && HarmIn(number, index) is var harm && harm < least)
            {
                (best, least) = (number, harm);
            }
        }

        // Greedy colouring: a new picture as long as there may be one, then the least harm.
        if (least > 0 && PictureCount < MaxPictures)
        {
            best = _shown.Count;
            _shown.Add([]);
            _empty.Add([]);
        }

        if (best >= 0)
        {
            kind[best].Add(index);
        }
    }

    /// <summary>How much of the objects of a picture would be lost if another were added.</summary>
    private double HarmIn(int number, int index) =>
        (ShownWeight * _shown[number].Sum(other => _harm[other, index])) + _empty[number].Sum(other => _harm[other, index]);
}
