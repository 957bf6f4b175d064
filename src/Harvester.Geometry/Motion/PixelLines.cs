using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Motion;

/// <summary>
/// The lines of sight of the centres of all pixels, in the camera's frame at depth 1. Without distortion, columns and rows are independent.
/// </summary>
public sealed class PixelLines
{
    private readonly double[] _right;
    private readonly double[] _up;
    private readonly bool _isSeparable;
    private readonly int _width;

    /// <summary>Works the lines out, once for all pictures of a camera.</summary>
    public PixelLines(CameraIntrinsics intrinsics)
    {
        Intrinsics = Guard.NotNull(intrinsics, nameof(intrinsics));
        ImageSize image = intrinsics.Image;
        _width = image.Width;
        _isSeparable = intrinsics.Lens.IsRectilinear;
        _right = new double[_isSeparable ? image.Width : image.PixelCount];
        _up = new double[_isSeparable ? image.Height : image.PixelCount];
        for (int i = 0; i < _right.Length; i++)
        {
            (int row, int column) = (i / image.Width, i % image.Width);
            _right[i] = LineOf(column, row).X;
        }

        for (int i = 0; i < _up.Length; i++)
        {
            (int row, int column) = _isSeparable ? (i, 0) : (i / image.Width, i % image.Width);
            _up[i] = -LineOf(column, row).Y;
        }
    }

    /// <summary>The camera's intrinsics.</summary>
    public CameraIntrinsics Intrinsics { get; }

    /// <summary>How far to the right a line leads at depth 1.</summary>
    public double RightOf(int column, int row) => _right[_isSeparable ? column : (row * _width) + column];

    /// <summary>How far up a line leads at depth 1.</summary>
    public double UpOf(int column, int row) => _up[_isSeparable ? row : (row * _width) + column];

    private Vector2D LineOf(int column, int row) =>
        Intrinsics.Lens.Undistort(
            new Vector2D((column + 0.5 - Intrinsics.Cx) / Intrinsics.Fx, (row + 0.5 - Intrinsics.Cy) / Intrinsics.Fy)
        );
}
