using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Sessions;

/// <summary>
/// Writes a session derived from others: the files of its frames, then the manifest, the labels and, last of all, session.json. Each file
/// is written only after everything that it refers to is on the disk.
/// </summary>
internal sealed class NewSession
{
    private readonly string _folder;
    private readonly SyncMode _sync;
    private readonly TextWriter _labels;
    private readonly TextWriter _manifest;
    private readonly SyncBatch _batch = new();
    private readonly List<KeyValuePair<string, FileDigest>> _files = [];
    private int _frames;

    private NewSession(string folder, SyncMode sync, TextWriter labels, TextWriter manifest)
    {
        _folder = folder;
        _sync = sync;
        _labels = labels;
        _manifest = manifest;
    }

    /// <summary>Writes a session.</summary>
    /// <param name="folder">Where it goes; the folder is made if it is not there.</param>
    /// <param name="sync">When to wait for the disk.</param>
    /// <param name="content">Writes the frames, then the files that belong to no single frame.</param>
    /// <param name="header">Gives the text of session.json once all frames are written.</param>
    public static void Write(string folder, SyncMode sync, Action<NewSession> content, Func<string> header)
    {
        Directory.CreateDirectory(folder);
        string text = "";
        bool isDurable = sync != SyncMode.Never;
        AtomicLines.Write(Path.Combine(folder, SessionReader.LabelsFile), isDurable, labels =>
            AtomicLines.Write(Path.Combine(folder, Manifest.FileName), isDurable, manifest =>
            {
                var session = new NewSession(folder, sync, labels, manifest);
                content(session);
                text = header();
                session.End(text);
            }));
        AtomicFile.Write(Path.Combine(folder, SessionInfo.FileName), text, isDurable);
    }

    /// <summary>Writes a file of the frame that is ended next.</summary>
    /// <param name="name">Its path within the session.</param>
    /// <param name="content">Writes the content.</param>
    public void WriteFile(string name, Action<Stream> content)
    {
        FileDigest digest = default;
        string path = Prepare(name);
        AtomicFile.Write(path, stream => digest = DigestStream.Write(stream, content), isDurable: false);
        Add(name, path, digest);
    }

    /// <summary>Places a file of another session under the same path.</summary>
    /// <param name="name">Its path within both sessions.</param>
    /// <param name="source">The other session.</param>
    /// <param name="transfer">Whether to link or to copy it.</param>
    /// <param name="digest">Its digest.</param>
    /// <exception cref="DatasetFormatException">There is no such file.</exception>
    public void Place(string name, SessionReader source, ImageTransfer transfer, Func<FileDigest> digest)
    {
        string path = Prepare(name);
        FileTransfer.Place(path, source.PathOf(name), transfer);
        Add(name, path, digest());
    }

    /// <summary>Ends a frame, whose files were written before.</summary>
    /// <param name="frame">Its number.</param>
    /// <param name="line">Its label line.</param>
    public void EndFrame(int frame, string line)
    {
        _manifest.WriteLine(Manifest.FrameLine(frame, FileDigest.Of(line), _files));
        _labels.WriteLine(line);
        _files.Clear();
        _frames++;
        if (_sync == SyncMode.Always || (_sync == SyncMode.Batch && _frames % SyncBatch.MaxFrames == 0))
        {
            _batch.Flush();
        }
    }

    private void End(string header)
    {
        foreach (KeyValuePair<string, FileDigest> file in _files.Append(new(SessionInfo.FileName, FileDigest.Of(header)))
            .OrderBy(file => file.Key, StringComparer.Ordinal))
        {
            _manifest.WriteLine(Manifest.FileLine(file.Key, file.Value));
        }

        if (_sync != SyncMode.Never)
        {
            _batch.AddFolder(Path.GetDirectoryName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(_folder)))!);
            _batch.Flush();
        }
    }

    private void Add(string name, string path, FileDigest digest)
    {
        _files.Add(new(name, digest));
        if (_sync != SyncMode.Never)
        {
            _batch.Add(path);
        }
    }

    private string Prepare(string name)
    {
        string target = InnerPath.Of(_folder, name);
        string folder = Path.GetDirectoryName(target)!;
        if (!Directory.Exists(folder))
        {
            Directory.CreateDirectory(folder);
            _batch.AddFolder(Path.GetDirectoryName(folder)!);
        }

        return target;
    }
}
