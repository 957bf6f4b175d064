using System.Text;
using System.Text.Json;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Maps;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Viewing;

/// <summary>
/// A session as a viewer asks for it: frames by their place in the label file, and what is known about all of them, which a thread of its
/// own reads. The session may still be written; its further frames appear. All members may be used by several threads.
/// </summary>
public sealed class SessionView : IDisposable
{
    private const long BytesPerStep = 64 << 20;
    private const int MaxViews = 64;

    private static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(500);

    private readonly SessionReader _session;
    private readonly LineIndex _lines;
    private readonly Overview _overview;
    private readonly Lazy<LaneMaps?> _maps;
    private readonly CancellationTokenSource _end = new();
    private readonly Thread _reading;
    private volatile SessionInfo _info;
    private volatile bool _isIndexed;
    private volatile string? _fault;

    /// <summary>Opens a session and begins to read it.</summary>
    /// <exception cref="DatasetFormatException">Its session.json is malformed.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public SessionView(SessionReader session)
    {
        ArgumentNullException.ThrowIfNull(session);
        _session = session;
        _info = session.ReadInfo();
        _lines = new LineIndex(session.PathOf(SessionReader.LabelsFile));
        _overview = new Overview([.. _info.Rig?.Cameras.Select(camera => camera.Name) ?? []]);
        _maps = new Lazy<LaneMaps?>(() => MapsOf(session));
        _isIndexed = !_lines.Extend(BytesPerStep);
        _reading = new Thread(Read)
        {
            IsBackground = true,
            Name = "read session",
            Priority = ThreadPriority.BelowNormal,
        };
        _reading.Start();
    }

    /// <summary>Name of the session.</summary>
    public string Name => Path.GetFileName(Path.GetFullPath(_session.Folder));

    /// <summary>Number of frames found so far.</summary>
    public int Frames => _lines.Count;

    /// <summary>What session.json says.</summary>
    internal SessionInfo Info => _info;

    /// <summary>Writes the page that shows the session.</summary>
    /// <returns>The policy under which a browser may run the page, for its Content-Security-Policy header.</returns>
    public string WritePage(Stream stream) => ViewPage.Write(stream, this);

    /// <summary>How far the session is read, as JSON.</summary>
    public byte[] State() =>
        Json(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("frames", Frames);
            json.WriteNumber("read", _overview.Count);
            json.WriteBoolean("isIndexed", _isIndexed);
            json.WriteBoolean("isClosed", _info.CapturedFrames is not null || _info.Fault is not null);
            json.WriteNumber("problems", _overview.Problems);
            json.WriteString("problem", _fault ?? _overview.FirstProblem);
            json.WriteString("limit", _overview.Limit ?? LimitOfLines());
            json.WriteEndObject();
        });

    /// <summary>The statistics and events of the frames that are read, as JSON.</summary>
    public byte[] Figures() =>
        Json(json =>
        {
            json.WriteStartObject();
            _overview.WriteFigures(json, _info);
            json.WriteEndObject();
        });

    /// <summary>The numbers of some successive frames; null if they are not read yet.</summary>
    public byte[]? Block(int number) => _overview.Block(number);

    /// <summary>The objects that a block has first, as JSON.</summary>
    public byte[] ObjectsOf(int block) =>
        Json(json =>
        {
            json.WriteStartObject();
            _overview.WriteObjects(json, block);
            json.WriteEndObject();
        });

    /// <summary>A frame as JSON.</summary>
    /// <param name="index">Its place in the label file, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    /// <exception cref="DatasetFormatException">Its line cannot be read.</exception>
    public byte[] Frame(int index)
    {
        FrameLabel label = LabelAt(index);
        return Json(json =>
        {
            json.WriteStartObject();
            json.WritePropertyName("frame");
            ReportFrame.Write(json, label);
            ReportData.WriteObjects(json, label.Objects);
            json.WriteStartArray("rasters");
            foreach (FrameRaster raster in Enum.GetValues<FrameRaster>().Where(raster => raster.FileOf(label) is not null))
            {
                json.WriteStringValue(JsonName.Of(raster));
            }

            if (_info.Rig is not null && SweepsOf(index, label).Any())
            {
                json.WriteStringValue("points");
            }

            json.WriteEndArray();
            if (_maps.Value is { } maps)
            {
                FrameLanes.Write(json, label, maps);
            }

            json.WriteEndObject();
        });
    }

    /// <summary>An image file of a frame.</summary>
    /// <returns>Its media type and path; null if the frame has none.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    /// <exception cref="DatasetFormatException">Its line or the file cannot be read.</exception>
    public (string MediaType, byte[] Content)? Raster(int index, FrameRaster raster)
    {
        if (raster.FileOf(LabelAt(index)) is not { } name)
        {
            return null;
        }

        byte[] content = InputFile.ReadAllBytes(_session.PathOf(name), InputFile.MaxPictureBytes);
        using var stream = new MemoryStream(content);
        return (ImageHeader.Read(stream).MediaType, content);
    }

    /// <summary>The points of the LiDARs at the moment of a frame, in its image and on the ground; <see cref="SeenPoints"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    /// <exception cref="DatasetFormatException">Its line or the points cannot be read.</exception>
    public byte[] Points(int index)
    {
        FrameLabel label = LabelAt(index);
        return SeenPoints.Of(_session, _info, label, SweepsOf(index, label));
    }

    /// <summary>The place of a frame, or of the next one that exists; the number of frames after the last.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <exception cref="DatasetFormatException">A line cannot be read.</exception>
    public int IndexOf(int frame)
    {
        while (!_isIndexed && _fault is null && !_end.IsCancellationRequested)
        {
            Thread.Sleep(10);
        }

        (int low, int high) = (0, Frames);
        while (low < high)
        {
            int middle = (low + high) / 2;
            (low, high) = LabelAt(middle).Frame < frame ? (middle + 1, high) : (low, middle);
        }

        return low;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _end.Cancel();
        _reading.Join();
        _end.Dispose();
        _lines.Dispose();
    }

    private static byte[] Json(Action<Utf8JsonWriter> write)
    {
        using var bytes = new MemoryStream();
        using (var json = new Utf8JsonWriter(bytes))
        {
            write(json);
        }

        return bytes.ToArray();
    }

    /// <summary>The LiDARs of a frame's moment, which are in the line of its first view.</summary>
    private IReadOnlyList<SweepLabel> SweepsOf(int index, FrameLabel label)
    {
        for (int before = index - 1; label.Lidar.Count == 0 && before >= 0 && index - before < MaxViews; before--)
        {
            FrameLabel other = LabelAt(before);
            if (label.Moment is null || other.Moment != label.Moment)
            {
                break;
            }

            label = other;
        }

        return label.Lidar;
    }

    private FrameLabel LabelAt(int index) => LabelAt(index, out _);

    private FrameLabel LabelAt(int index, out int lineBytes)
    {
        byte[] line = _lines.Read(index);
        lineBytes = line.Length;
        try
        {
            FrameLabel label = FrameLabelParser.Parse(Encoding.UTF8.GetString(line));
            return SessionReader.IdProblem(label) is { } problem ? throw new DatasetFormatException(problem) : label;
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{SessionReader.LabelsFile}, line {index + 1}: {e.Message}", e);
        }
    }

    /// <summary>The lanes of the session's roads; null if it has none, or none that can be read.</summary>
    private static LaneMaps? MapsOf(SessionReader session)
    {
        try
        {
            return SessionLanes.Of(session);
        }
        catch (Exception e) when (e is DatasetFormatException or IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    private string? LimitOfLines() =>
        _lines.IsFull ? $"The viewer shows at most {LineIndex.MaxLines} frames of a session, and this one may have more." : null;

    private void Read()
    {
        try
        {
            do
            {
                while (_lines.Extend(BytesPerStep))
                {
                    _end.Token.ThrowIfCancellationRequested();
                }

                _isIndexed = true;
                for (int last = Frames; _overview.Count < last && _overview.Limit is null; )
                {
                    _end.Token.ThrowIfCancellationRequested();
                    ReadNext();
                }

                _info = _info.CapturedFrames is null ? _session.ReadInfo() : _info;
            } while (!_end.Token.WaitHandle.WaitOne(Pause));
        }
        catch (OperationCanceledException)
        {
            // The viewer is closed.
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or DatasetFormatException)
        {
            _fault = e.Message;
        }
    }

    private void ReadNext()
    {
        try
        {
            _overview.Add(LabelAt(_overview.Count, out int lineBytes), lineBytes);
        }
        catch (DatasetFormatException e)
        {
            _overview.AddProblem(e.Message);
        }
    }
}
