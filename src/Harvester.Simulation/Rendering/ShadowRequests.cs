namespace Harvester.Simulation.Rendering;

/// <summary>Finds the places of a picture on which shadows may lie, and has only their shadows drawn.</summary>
/// <param name="shadows">The shadows.</param>
/// <param name="screen">The triangles that pixels show.</param>
internal sealed class ShadowRequests(SceneShadows shadows, ScreenTriangles screen)
{
    /// <summary>Draws the shadows that a picture may show.</summary>
    /// <param name="shader">The picture's shader.</param>
    /// <param name="scene">What is drawn.</param>
    /// <param name="camera">The camera.</param>
    /// <param name="rows">Room for a row of each band.</param>
    /// <param name="ids">The numbers of the triangles that pixels show.</param>
    /// <param name="nearness">Near / depth of the pixels.</param>
    public void Draw(PixelShader shader, RenderScene scene, RenderCamera camera, PixelRow[] rows, int[] ids, float[] nearness)
    {
        shadows.Aim(scene, camera);
        if (shadows.AreCast)
        {
            Parallel.For(
                0,
                rows.Length,
                band =>
                {
                    int top = band * DepthTiles.Size;
                    for (int number = top; number < Math.Min(camera.Height, top + DepthTiles.Size); number++)
                    {
                        rows[band].Number = number;
                        int start = number * camera.Width;
                        Want(shader, rows[band], ids.AsSpan(start, camera.Width), nearness.AsSpan(start, camera.Width));
                    }
                }
            );
        }

        shadows.Draw(scene);
    }

    /// <summary>How many pixels from the first on show the same.</summary>
    public static int LengthOf(ReadOnlySpan<int> ids)
    {
        int length = ids.IndexOfAnyExcept(ids[0]);
        return length < 0 ? ids.Length : length;
    }

    private void Want(PixelShader shader, PixelRow row, ReadOnlySpan<int> ids, ReadOnlySpan<float> nearness)
    {
        shader.BeginShadows(row, nearness);
        for (int column = 0; column < ids.Length; )
        {
            int length = LengthOf(ids[column..]);
            if (ids[column] != ScreenTriangles.Nothing)
            {
                shader.WantShadows(screen[ids[column]], row, column, length);
            }

            column += length;
        }
    }
}
