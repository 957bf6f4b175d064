using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>
/// The files that labels name: they lie in the session, belong to one frame, are whole, and have the size that the label says; masks show
/// what the label says.
/// </summary>
internal sealed class FileCheck
{
    private const int MaskBitsPerPixel = 16;

    private readonly SessionReader _session;
    private readonly HashSet<string> _named = new(StringComparer.Ordinal);

    public FileCheck(SessionReader session) => _session = session;

    public IEnumerable<string> Problems(FrameLabel label)
    {
        IEnumerable<string> mask = label.Mask is { } name ? MaskProblems(label, name) : MaskCheck.ProblemsWithoutMask(label);
        return Problem("image", label.Image, label.Camera, bitsPerPixel: null) is { } image ? mask.Prepend(image) : mask;
    }

    private IEnumerable<string> MaskProblems(FrameLabel label, string name)
    {
        if (Problem("mask", name, label.Camera, MaskBitsPerPixel) is { } problem)
        {
            return [problem];
        }

        try
        {
            return MaskCheck.Problems(label, PngDecoder.ReadInstanceMap(_session.PathOf(name)));
        }
        catch (DatasetFormatException e)
        {
            return [$"mask '{name}' cannot be used: {e.Message}"];
        }
    }

    private string? Problem(string field, string name, CameraLabel camera, int? bitsPerPixel)
    {
        if (!_session.IsWithin(name))
        {
            return $"{field} '{name}' points out of the session.";
        }

        if (!_named.Add(name))
        {
            return $"{field} '{name}' belongs to an earlier line already.";
        }

        string path = _session.PathOf(name);
        if (!File.Exists(path))
        {
            return $"{field} '{name}' is missing.";
        }

        try
        {
            return Problem($"{field} '{name}'", ImageHeader.Read(path), camera, bitsPerPixel);
        }
        catch (DatasetFormatException e)
        {
            return $"{field} '{name}' cannot be used: {e.Message}";
        }
    }

    private static string? Problem(string what, ImageHeader header, CameraLabel camera, int? bitsPerPixel)
    {
        if (header.Size.Width != camera.Width || header.Size.Height != camera.Height)
        {
            return $"{what} is {header.Size.Width} x {header.Size.Height}, but its label says {camera.Width} x {camera.Height}.";
        }

        return bitsPerPixel is { } bits && header.BitsPerPixel != bits
            ? $"{what} has {header.BitsPerPixel} bits a pixel instead of {bits}." : null;
    }
}
