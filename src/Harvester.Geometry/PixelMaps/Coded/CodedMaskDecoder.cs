using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// Decodes an instance map from the pictures of a <see cref="VisibilityCode"/>. Each pixel is explained by a stack of objects, so that the
/// objects behind others are found too; then each object is separated from its shadow and its outline is settled. Work is done in
/// steps of a row or an object, so that it can be spread over ticks.
/// </summary>
public sealed class CodedMaskDecoder : IMaskDecoder
{
    /// <summary>Step between the rows and columns outside all silhouettes that are searched for shadows.</summary>
    private const int ShadowStep = 4;

    /// <summary>
    /// A shadow falls within this many times the size of the box of its object, and pixels. A sun 34° above the horizon casts shadows 1.5
    /// times as long as the object is high.
    /// </summary>
    private const double ShadowReach = 1.5;
    private const double ShadowPixels = 30;

    /// <summary>
    /// A pixel whose second best explanation costs less than this more is undetermined, unless its neighbours agree with it. Costs are
    /// -2 ln(likelihood), so the best one is e^(6 / 2) = 20 times as likely as the second.
    /// </summary>
    private const double ClearMargin = 6;
    private const int AgreeingNeighbours = 1;

    private readonly Camera _camera;
    private readonly ImageSize _image;
    private readonly PictureStack _stack;
    private readonly PixelFit _fit;
    private readonly ObjectPlane[] _planes;
    private readonly Box2D[] _shadows;
    private readonly ShadowLight _light = new();
    private readonly ushort[][] _order;
    private readonly float[] _margins;
    private readonly NoiseMap _noise;

    /// <summary>Prepares to decode pictures.</summary>
    /// <param name="camera">The camera of the pictures.</param>
    /// <param name="targets">The targets.</param>
    /// <param name="code">The code by which they were hidden.</param>
    /// <param name="pictures">The pictures in the order of the code: red, green and blue of each pixel, rows from the top.</param>
    /// <exception cref="ArgumentException">The number or size of the pictures does not match.</exception>
    public CodedMaskDecoder(Camera camera, IReadOnlyList<MapTarget> targets, VisibilityCode code, IReadOnlyList<byte[]> pictures)
    {
        _camera = Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(targets, nameof(targets));
        ImageSize image = camera.Image;
        _image = image;
        Guard.NotNull(code, nameof(code));
        if (
            Guard.NotNull(pictures, nameof(pictures)).Count != code.PictureCount
            || pictures.Any(picture => picture.Length != 3 * image.PixelCount)
        )
        {
            throw new ArgumentException("The pictures do not match the code or the size of the image.", nameof(pictures));
        }

        _stack = new PictureStack([.. pictures.Take(pictures.Count - 1)]);
        uint[] shown = [.. Enumerable.Range(0, targets.Count).Select(code.PicturesOf)];
        _fit = new PixelFit(_stack, shown, [.. targets.Select(target => SilhouettePainter.DistanceOf(camera, target))]);
        _planes = [.. targets.Select(target => new ObjectPlane(target, image))];
        _shadows = [.. targets.Select(target => ShadowOf(target.Projection.Box ?? default))];
        _noise = new NoiseMap(pictures, image);
        _order = new ushort[image.PixelCount][];
        _margins = new float[image.PixelCount];
    }

    /// <inheritdoc/>
    public CodedMask? Mask { get; private set; }

    private static Box2D ShadowOf(Box2D box)
    {
        double more = ShadowPixels + (ShadowReach * Math.Max(box.Width, box.Height));
        return new Box2D(box.XMin - more, box.YMin - more, box.XMax + more, box.YMax + more);
    }

    /// <inheritdoc/>
    public IEnumerable<WorkStep> Decode()
    {
        List<int> candidates = [];
        List<int> casters = [];

        // First the light of shadows is learnt where only a shadow can change a pixel: outside all silhouettes, near an object.
        for (int row = 0; row < _image.Height; row += ShadowStep)
        {
            FindShadows(row, candidates, casters);
            yield return WorkStep.Pause;
        }

        // Then each pixel is explained by itself.
        _light.Solve();
        for (int row = 0; row < _image.Height; row++)
        {
            FitRow(row, candidates, casters);
            yield return WorkStep.Pause;
        }

        // Last, each object is looked at as a whole: its shadow is separated, then its outline is settled.
        var separator = new ShadowSeparator(_camera, _noise, _light);
        var edges = new EdgeSettler(_stack, _noise, _image.Width);
        foreach (ObjectPlane plane in _planes)
        {
            separator.Separate(plane);
            edges.Settle(plane);
            yield return WorkStep.Pause;
        }

        Mask = Assembled();
    }

    private void Gather(int column, int row, List<int> candidates, List<int> casters)
    {
        candidates.Clear();
        casters.Clear();
        for (int i = 0; i < _planes.Length; i++)
        {
            if (_planes[i].Covers(column, row))
            {
                candidates.Add(i);
            }

            if (column >= _shadows[i].XMin && column <= _shadows[i].XMax && row >= _shadows[i].YMin && row <= _shadows[i].YMax)
            {
                casters.Add(i);
            }
        }
    }

    private void FindShadows(int row, List<int> candidates, List<int> casters)
    {
        for (int column = 0; column < _image.Width; column += ShadowStep)
        {
            Gather(column, row, candidates, casters);
            if (candidates.Count > 0 || casters.Count == 0)
            {
                continue;
            }

            int pixel = (row * _image.Width) + column;
            _stack.Load(pixel);
            if (_fit.FindShadow(_noise.At(pixel), casters) is { } shadow)
            {
                _light.Add(shadow.Shaded, shadow.Lit);
            }
        }
    }

    private void FitRow(int row, List<int> candidates, List<int> casters)
    {
        for (int column = 0; column < _image.Width; column++)
        {
            Gather(column, row, candidates, casters);
            if (candidates.Count == 0)
            {
                continue;
            }

            int pixel = (row * _image.Width) + column;
            _stack.Load(pixel);
            _fit.Fit(_noise.At(pixel), candidates, casters);
            PixelFit.Stack best = _fit.Best;
            _margins[pixel] = (float)Math.Min(float.MaxValue, _fit.Margin);
            if (best.Count == 0)
            {
                continue;
            }

            var order = new ushort[best.Count];
            for (int layer = 0; layer < best.Count; layer++)
            {
                ObjectPlane plane = _planes[best.Objects[layer]];

                // Group k holds the pictures that show layer k; the next group shows what is behind it.
                uint front = best.Groups[layer];
                uint behind = best.Groups[layer + 1];
                plane.Set(
                    plane.IndexOf(column, row),
                    _stack.MeanIn(front),
                    PictureStack.CountOf(front),
                    _stack.MeanIn(behind),
                    PictureStack.CountOf(behind)
                );
                order[layer] = (ushort)best.Objects[layer];
            }

            _order[pixel] = order;
        }
    }

    private CodedMask Assembled()
    {
        var map = new InstanceMap(_image);
        var undetermined = new PixelMap(_image);
        var amodal = new Dictionary<ushort, PixelMap>();
        foreach (ObjectPlane plane in _planes)
        {
            var pixels = new PixelMap(_image);
            for (int y = 0; y < plane.Height; y++)
            {
                for (int x = 0; x < plane.Width; x++)
                {
                    if (!plane.Has(x, y))
                    {
                        continue;
                    }

                    int column = x + plane.Left;
                    int row = y + plane.Top;
                    pixels[column, row] = true;
                    if (IsFront(plane, column, row))
                    {
                        map[column, row] = plane.Target.Number;
                    }
                }
            }

            amodal[plane.Target.Number] = pixels;
        }

        MajorityFilter.Apply(map, (number, column, row) => amodal[number][column, row]);
        MarkUndetermined(map, undetermined);
        return new CodedMask(map, undetermined, amodal);
    }

    /// <summary>Takes pixels out of the map whose explanation is hardly better than another, and with which few neighbours agree.</summary>
    private void MarkUndetermined(InstanceMap map, PixelMap undetermined)
    {
        for (int row = 1; row < _image.Height - 1; row++)
        {
            for (int column = 1; column < _image.Width - 1; column++)
            {
                int pixel = (row * _image.Width) + column;
                if (
                    _order[pixel] is not null
                    && _margins[pixel] < ClearMargin
                    && MajorityFilter.CountAround(map.Ids, _image.Width, pixel, map.Ids[pixel]) <= AgreeingNeighbours
                )
                {
                    undetermined[column, row] = true;
                }
            }
        }

        for (int row = 1; row < _image.Height - 1; row++)
        {
            for (int column = 1; column < _image.Width - 1; column++)
            {
                map[column, row] = undetermined[column, row] ? (ushort)0 : map[column, row];
            }
        }
    }

    /// <summary>Whether an object of a pixel has no other in front of it there.</summary>
    private bool IsFront(ObjectPlane plane, int column, int row)
    {
        foreach (ushort index in _order[(row * _image.Width) + column] ?? [])
        {
            ObjectPlane other = _planes[index];
            if (other == plane)
            {
                return true;
            }

            int at = other.IndexOf(column, row);
            if (at >= 0 && other.State[at] == PixelState.Object)
            {
                return false;
            }
        }

        return true;
    }
}
