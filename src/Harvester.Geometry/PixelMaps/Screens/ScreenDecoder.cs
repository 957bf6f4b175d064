using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Decodes a mask from the pictures of a <see cref="ScreenPlan"/>: each object is found before its screen, whatever else is in front of it
/// in the picture with all objects, and then the object in front is found at each pixel. A step is an object or a part of the second.
/// </summary>
internal sealed class ScreenDecoder : IMaskDecoder
{
    /// <summary>A pixel shows an object if the pictures with and without objects differ by more than this, squared grey levels.</summary>
    private const double ChangedSquares = 30 * 30;

    /// <summary>Number of pixels in a step.</summary>
    private const int StepPixels = 4096;

    private readonly Camera _camera;
    private readonly IReadOnlyList<MapTarget> _targets;
    private readonly ScreenPlan _plan;
    private readonly IReadOnlyList<byte[]> _pictures;
    private readonly ScreenMatte[] _mattes;

    public ScreenDecoder(Camera camera, IReadOnlyList<MapTarget> targets, ScreenPlan plan, IReadOnlyList<byte[]> pictures)
    {
        (_camera, _targets, _plan) = (camera, targets, plan);
        _pictures = Guard.NotNull(pictures, nameof(pictures));
        if (pictures.Count != plan.PictureCount || pictures.Any(picture => picture.Length != 3 * camera.Image.PixelCount))
        {
            throw new ArgumentException("The pictures do not match the plan or the size of the image.", nameof(pictures));
        }

        _mattes = new ScreenMatte[targets.Count];
    }

    /// <inheritdoc/>
    public CodedMask? Mask { get; private set; }

    /// <inheritdoc/>
    public IEnumerable<WorkStep> Decode()
    {
        // First each object by itself, with all pixels of its screen.
        double darkest = FrameShadows.Darkest(_camera.Image, _plan.Screens, _pictures[0], _pictures[1]);
        var map = new InstanceMap(_camera.Image);
        var undetermined = new PixelMap(_camera.Image);
        var amodal = new Dictionary<ushort, PixelMap>();
        var several = new SortedDictionary<int, List<int>>();
        var owners = new int[_camera.Image.PixelCount];
        for (int i = 0; i < _mattes.Length; i++)
        {
            var view = new ScreenView(
                _camera,
                _plan.Screens[i],
                _pictures[1],
                PictureOf(_plan.ShownPicture(i), i),
                PictureOf(_plan.EmptyPicture(i), i)
            );
            _mattes[i] = new ScreenMatte(view, darkest);
            amodal[_targets[i].Number] = Collect(i, owners, several);
            yield return WorkStep.Pause;
        }

        // Then the pixels that several objects claim vote on the order of each pair.
        var order = new FrontOrder(_camera, _targets, _plan, _pictures, _mattes);
        foreach (KeyValuePair<int, List<int>> pixel in several)
        {
            order.Vote(pixel.Value, pixel.Key % _camera.Image.Width, pixel.Key / _camera.Image.Width);
        }

        yield return WorkStep.Pause;

        // Last, each pixel goes to its only object or to the one in front.
        for (int pixel = 0; pixel < owners.Length; pixel++)
        {
            if (owners[pixel] != 0)
            {
                (int column, int row) = (pixel % _camera.Image.Width, pixel / _camera.Image.Width);
                int front = several.TryGetValue(pixel, out List<int>? there) ? order.FrontOf(there, column, row) : owners[pixel] - 1;
                map[column, row] = _targets[front].Number;
            }

            if (pixel % StepPixels == 0)
            {
                yield return WorkStep.Pause;
            }
        }

        MarkUndetermined(map, undetermined);
        Mask = new CodedMask(map, undetermined, amodal);
    }

    /// <summary>The pixels of an object, which become those of the map too.</summary>
    private PixelMap Collect(int target, int[] owners, SortedDictionary<int, List<int>> several)
    {
        ScreenMatte matte = _mattes[target];
        var pixels = new PixelMap(_camera.Image);
        for (int index = 0; index < matte.State.Length; index++)
        {
            if (matte.State[index] == MatteState.Object)
            {
                (int column, int row) = (matte.Left + (index % matte.Width), matte.Top + (index / matte.Width));
                int pixel = (row * _camera.Image.Width) + column;
                pixels[column, row] = true;
                if (several.TryGetValue(pixel, out List<int>? there))
                {
                    there.Add(target);
                }
                else if (owners[pixel] != 0)
                {
                    several[pixel] = [owners[pixel] - 1, target];
                }

                owners[pixel] = target + 1;
            }
        }

        return pixels;
    }

    /// <summary>Marks pixels that change with the objects and may show one whose screen is hidden there.</summary>
    private void MarkUndetermined(InstanceMap map, PixelMap undetermined)
    {
        (byte[] all, byte[] none) = (_pictures[0], _pictures[1]);
        foreach ((ScreenMatte matte, ObjectScreen screen) in _mattes.Zip(_plan.Screens, static (matte, screen) => (matte, screen)))
        {
            for (int index = 0; index < matte.State.Length; index++)
            {
                (int column, int row) = (matte.Left + (index % matte.Width), matte.Top + (index / matte.Width));
                int first = 3 * ((row * _camera.Image.Width) + column);
                (int red, int green, int blue) = (
                    all[first] - none[first],
                    all[first + 1] - none[first + 1],
                    all[first + 2] - none[first + 2]
                );
                undetermined[column, row] |=
                    matte.State[index] == MatteState.Unknown
                    && screen.Spans.Contains(column, row)
                    && map[column, row] == 0
                    && (red * red) + (green * green) + (blue * blue) > ChangedSquares;
            }
        }
    }

    private ScreenPicture? PictureOf(int number, int target) =>
        number == 0
            ? null
            : new ScreenPicture(_pictures[number], [.. _plan.Nearer(number, target).Select(other => _plan.Screens[other].Spans)]);
}
