using System.Text.RegularExpressions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Writes the files of a shared folder: an image per frame, of which the last few are kept, and state.txt. Each is renamed into place,
/// state.txt after its image. A frame that cannot be written now, as while a client holds state.txt open, is kept for another attempt.
/// </summary>
internal sealed class FrameFiles(string folder) : IDisposable
{
    private const string State = "state.txt";

    /// <summary>What state.txt has in place of the name of an image when a frame has no image.</summary>
    private const string NoPicture = "none";
    private const int PicturesKept = 10;

    /// <summary>If this many cannot be deleted, writing more would fill the disk.</summary>
    private const int MaxPictures = 100;

    private readonly List<string> _pictures = [];
    private readonly PngEncoder _encoder = new();
    private readonly MemoryStream _png = new();
    private BridgeState? _waiting;
    private bool _isPictureWritten;
    private bool _mayHaveLeftovers;

    /// <summary>
    /// Deletes the images and temporary files of earlier drives, recognised by their names. Files that another process holds open stay.
    /// </summary>
    /// <exception cref="IOException">The folder cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder cannot be read.</exception>
    public void DeleteEarlier()
    {
        foreach (string path in Directory.GetFiles(folder, "frame_*.png"))
        {
            if (IsPicture(Path.GetFileName(path)))
            {
                TryDelete(path);
            }
        }

        DeleteLeftovers();
    }

    /// <summary>Writes the game's hello, with the version of the protocol.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">It cannot be written.</exception>
    public void WriteHello() =>
        AtomicFile.Write(Path.Combine(folder, BridgeProtocol.HelloFile), BridgeProtocol.HelloOfGame + "\n", isDurable: false);

    /// <summary>Sets the frame to write, in place of one that could not be written yet.</summary>
    public void Put(BridgeState state, PixelBuffer picture)
    {
        _png.SetLength(0);
        if (state.HasPicture)
        {
            _encoder.Write(picture, _png);
        }

        _waiting = state;
        _isPictureWritten = false;
    }

    /// <summary>Writes the waiting frame, if there is one.</summary>
    /// <exception cref="IOException">The frame cannot be written now.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder is not writable.</exception>
    /// <exception cref="BridgeException">Too many old images cannot be deleted.</exception>
    public void Write()
    {
        if (_waiting is not { } state)
        {
            return;
        }

        string name = state.HasPicture ? FormattableString.Invariant($"frame_{state.Frame:00000000}.png") : NoPicture;
        if (!_isPictureWritten && state.HasPicture)
        {
            WritePicture(name);
        }

        byte[] text = BridgeText.StateFile(state, name);
        WriteWhole(State, text, text.Length);
        _waiting = null;
    }

    /// <summary>Frees memory; the files stay.</summary>
    public void Dispose() => _png.Dispose();

    private void WritePicture(string name)
    {
        DeleteOldPictures();
        if (_pictures.Count >= MaxPictures)
        {
            throw new BridgeException(
                FormattableString.Invariant($"{MaxPictures} old pictures cannot be deleted; no frame is written until they are.")
            );
        }

        // The folder may have been deleted.
        Directory.CreateDirectory(folder);
        WriteWhole(name, _png.GetBuffer(), (int)_png.Length);
        _pictures.Add(name);
        _isPictureWritten = true;
    }

    /// <summary>Makes room for one more image. A file that another process holds open is deleted at a later frame.</summary>
    private void DeleteOldPictures()
    {
        for (int i = _pictures.Count - PicturesKept; i >= 0; i--)
        {
            if (TryDelete(Path.Combine(folder, _pictures[i])))
            {
                _pictures.RemoveAt(i);
            }
        }
    }

    private static bool IsPicture(string name) => Regex.IsMatch(name, @"\Aframe_[0-9]{8}\.png\z");

    /// <returns>Whether the file is gone; it is too if the folder is.</returns>
    private static bool TryDelete(string path)
    {
        try
        {
            File.Delete(path);
            return true;
        }
        catch (DirectoryNotFoundException)
        {
            return true;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    private void WriteWhole(string name, byte[] bytes, int count)
    {
        try
        {
            AtomicFile.Write(Path.Combine(folder, name), stream => stream.Write(bytes, 0, count), isDurable: false);
        }
        catch
        {
            _mayHaveLeftovers = true;
            throw;
        }

        if (_mayHaveLeftovers)
        {
            // After a failed write, the temporary file may be as impossible to delete as the target was to write.
            DeleteLeftovers();
            _mayHaveLeftovers = false;
        }
    }

    private void DeleteLeftovers() =>
        AtomicFile.DeleteLeftovers(folder, target => target is State or BridgeProtocol.HelloFile || IsPicture(target));
}
