using System.Globalization;
using System.Text;
using System.Xml;
using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>Writes the elements of an OpenStreetMap file, version 0.6. All ids of a file differ.</summary>
internal sealed class OsmXml : IDisposable
{
    private const string DegreeFormat = "0.###########";
    private const string MetreFormat = "0.####";

    private readonly XmlWriter _xml;
    private long _lastId;

    public OsmXml(Stream stream)
    {
        _xml = XmlWriter.Create(
            stream,
            new XmlWriterSettings
            {
                Indent = true,
                NewLineChars = "\n",
                Encoding = new UTF8Encoding(false),
                CloseOutput = false,
            }
        );
        _xml.WriteStartElement("osm");
        _xml.WriteAttributeString("version", "0.6");
        _xml.WriteAttributeString("generator", "GtaDataHarvester");
    }

    /// <summary>Writes a node at a place, metres, world, and returns its id.</summary>
    public long Node(Vector3D place)
    {
        (double latitude, double longitude) = LocalMercator.Of(place);
        long id = Begin("node");
        _xml.WriteAttributeString("lat", Text(latitude, DegreeFormat));
        _xml.WriteAttributeString("lon", Text(longitude, DegreeFormat));
        Tag("ele", Text(place.Z, MetreFormat));
        Tag("local_x", Text(place.X, MetreFormat));
        Tag("local_y", Text(place.Y, MetreFormat));
        _xml.WriteEndElement();
        return id;
    }

    /// <summary>Writes a way, and returns its id.</summary>
    public long Way(IEnumerable<long> nodes, params IEnumerable<(string Key, string Value)> tags)
    {
        long id = Begin("way");
        foreach (long node in nodes)
        {
            _xml.WriteStartElement("nd");
            _xml.WriteAttributeString("ref", Text(node));
            _xml.WriteEndElement();
        }

        return End(id, tags);
    }

    /// <summary>Takes the id of a relation that is written later.</summary>
    public long NextId() => ++_lastId;

    /// <summary>Writes a relation.</summary>
    public void Relation(
        long id,
        IEnumerable<(string Type, long Id, string Role)> members,
        params IEnumerable<(string Key, string Value)> tags
    )
    {
        Begin("relation", id);
        foreach ((string type, long member, string role) in members)
        {
            _xml.WriteStartElement("member");
            _xml.WriteAttributeString("type", type);
            _xml.WriteAttributeString("ref", Text(member));
            _xml.WriteAttributeString("role", role);
            _xml.WriteEndElement();
        }

        End(id, tags);
    }

    /// <summary>Ends the file. A file that is not ended is not valid.</summary>
    public void End()
    {
        _xml.WriteEndElement();
        _xml.Flush();
    }

    public void Dispose() => _xml.Dispose();

    private long Begin(string element)
    {
        long id = NextId();
        Begin(element, id);
        return id;
    }

    private void Begin(string element, long id)
    {
        _xml.WriteStartElement(element);
        _xml.WriteAttributeString("id", Text(id));
    }

    private long End(long id, IEnumerable<(string Key, string Value)> tags)
    {
        foreach ((string key, string value) in tags)
        {
            Tag(key, value);
        }

        _xml.WriteEndElement();
        return id;
    }

    private void Tag(string key, string value)
    {
        _xml.WriteStartElement("tag");
        _xml.WriteAttributeString("k", key);
        _xml.WriteAttributeString("v", value);
        _xml.WriteEndElement();
    }

    private static string Text(long id) => id.ToString(CultureInfo.InvariantCulture);

    private static string Text(double value, string format)
    {
        string text = value.ToString(format, CultureInfo.InvariantCulture);
        return text == "-0" ? "0" : text;
    }
}
