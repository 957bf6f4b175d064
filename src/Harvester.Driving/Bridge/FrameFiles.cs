using System;
using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The files that go out over a shared folder: a picture a frame, of which the last ones stay, and state.txt. Each appears whole, by
/// renaming, state.txt after its picture. A frame that cannot be written now, as when a client holds state.txt open, is kept for another
/// try.
/// </summary>
internal sealed class FrameFiles(string folder) : IDisposable
{
    private const string State = "state.txt";
    private const int PicturesKept = 10;

    /// <summary>Where so many cannot be deleted, writing more would fill the disk.</summary>
    private const int MaxPictures = 100;

    private readonly List<string> _pictures = [];
    private readonly PngEncoder _encoder = new();
    private readonly MemoryStream _png = new();
    private BridgeState? _waiting;
    private bool _isPictureWritten;
    private bool _mayHaveLeftovers;

    /// <summary>
    /// Deletes the pictures of earlier drives and what these left unfinished, known by their names. What somebody holds fast stays.
    /// </summary>
    /// <exception cref="IOException">The folder cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be read.</exception>
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

    /// <summary>Puts a frame in the place of the one that could not be written yet.</summary>
    public void Put(BridgeState state, PixelBuffer picture)
    {
        _png.SetLength(0);
        _encoder.Write(picture, _png);
        _waiting = state;
        _isPictureWritten = false;
    }

    /// <summary>Writes the frame that waits, if one does.</summary>
    /// <exception cref="IOException">It cannot be written now.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be written.</exception>
    /// <exception cref="BridgeException">Too many old pictures cannot be deleted.</exception>
    public void Write()
    {
        if (_waiting is not { } state)
        {
            return;
        }

        string name = FormattableString.Invariant($"frame_{state.Frame:00000000}.png");
        if (!_isPictureWritten)
        {
            WritePicture(name);
        }

        byte[] text = BridgeText.StateFile(state, name);
        WriteWhole(State, text, text.Length);
        _waiting = null;
    }

    /// <summary>Gives back memory; the files stay.</summary>
    public void Dispose() => _png.Dispose();

    private void WritePicture(string name)
    {
        DeleteOldPictures();
        if (_pictures.Count >= MaxPictures)
        {
            throw new BridgeException(
                FormattableString.Invariant($"{MaxPictures} old pictures cannot be deleted; no frame is written until they can."));
        }

        // The folder may have been taken away.
        Directory.CreateDirectory(folder);
        WriteWhole(name, _png.GetBuffer(), (int)_png.Length);
        _pictures.Add(name);
        _isPictureWritten = true;
    }

    /// <summary>Makes room for one picture more. What somebody holds fast goes another time.</summary>
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

    /// <returns>Whether it is gone, as it is with the folder too.</returns>
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
            AtomicFile.Write(Path.Combine(folder, name), stream => stream.Write(bytes, 0, count));
        }
        catch
        {
            _mayHaveLeftovers = true;
            throw;
        }

        if (_mayHaveLeftovers)
        {
            // Of a write that failed, the temporary file may have been as little to be deleted as the file to be written.
            DeleteLeftovers();
            _mayHaveLeftovers = false;
        }
    }

    private void DeleteLeftovers() => AtomicFile.DeleteLeftovers(folder, target => target == State || IsPicture(target));
}
