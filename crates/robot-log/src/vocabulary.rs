//! The words by which a value is known in the name of a column, in English, German, French, Spanish and Italian,
//! without accents.

/// How the name of a column may say a value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way<'w> {
    /// The name, without its unit, is these words.
    Whole(&'w str),
    /// The name begins with this word.
    First(&'w str),
    /// These words are among those of the name.
    Within(&'w str),
}

/// Words for how far a number may be off: such a column holds no value but a σ.
pub(crate) struct SigmaWords;

impl SigmaWords {
    pub const ALL: [&str; 19] = [
        "covariance",
        "cov",
        "std",
        "stddev",
        "stdev",
        "dev",
        "sigma",
        "σ",
        "variance",
        "var",
        "accuracy",
        "uncertainty",
        "error",
        "err",
        "standardabweichung",
        "genauigkeit",
        "precision",
        "desviacion",
        "precisione",
    ];
}

/// The ways to say a value, the clearest first; `=` before one that is the whole name, `^` before its first word.
const WAYS: [(&str, &str); 21] = [
    (
        "time",
        "header stamp sec,header stamp secs,header stamp,=stamp sec,=stamp secs,=time,=times,=timestamp,=t,=ts,=stamp,\
         =zeit,=temps,=tiempo,=tempo,=zeitstempel,=sec,=secs,=seconds,=utc,=clock,=datetime,=date time,timestamp,\
         =i tow,=itow,=micros,=millis,=unix,=epoch,=posix,=unixtime,=logtime,=systime,time stamp,stamp,time,\
         seconds elapsed,elapsed,zeit,zeitstempel,uhrzeit,temps,horodatage,heure,tiempo,hora,tempo,ora,sec,secs,\
         seconds,clock,t",
    ),
    (
        "fraction",
        "stamp nanosec,stamp nsec,stamp nsecs,stamp nanosecs,stamp usec,stamp usecs,=nanosec,=nsec,=nsecs,\
                  =nanosecs,=nanoseconds,=usec,=usecs,=microseconds,=ns,=us,=msec",
    ),
    (
        "omega",
        "angular velocity z,angular z,rotation rate z,gyroscope z,gyro z,gyr z,gyroskop z,omega z,=wz,yaw rate,\
         yawrate,yaw speed,yawspeed,yaw vel,yaw velocity,turn rate,heading rate,=omega,=ω,=w,omega,ω,drehrate,\
         winkelgeschwindigkeit,gierrate,drehgeschwindigkeit,vitesse angulaire,vitesse rotation,vitesse lacet,\
         taux lacet,velocidad angular,velocidad giro,velocita angolare,velocita rotazione,velocita imbardata,\
         angular velocity,angular speed,angular,rotational,wz,gyro,rate of turn,=rot",
    ),
    (
        "v",
        "linear x,=v,=vx,=speed,=spd,=sog,speed,forward,=geschwindigkeit,linear,velocity,vel,spd,v x,vx,^v,\
         geschwindigkeit,geschw,fahrgeschwindigkeit,vitesse,velocidad,velocita,=stw,surge",
    ),
    (
        "distance",
        "=distance,=dist,=d,=ds,distance,dist,travelled,traveled,delta s,strecke,weg,wegstrecke,distancia,distanza",
    ),
    (
        "turn",
        "turn,dtheta,dyaw,dheading,delta theta,delta heading,delta yaw,rotation,drehung,drehwinkel,giro,rotazione",
    ),
    ("barcode", "barcode,code"),
    (
        "landmark",
        "landmark,beacon,buoy,anchor,reflector,transponder,tag,marker,feature,subject,=id,id,barcode,landmarke,bake,\
         anker,reflektor,balise,amer,ancre,reflecteur,boje,bouee,boya,baliza,ancla,boa,faro,ancora,riflettore,=name,\
         =label,=bezeichnung,=nom,=nombre,=nome",
    ),
    ("landmark x", "landmark x,beacon x,anchor x,buoy x,marker x,feature x,bake x,anker x,boje x,lm x,=bx,=lx,=ax"),
    ("landmark y", "landmark y,beacon y,anchor y,buoy y,marker y,feature y,bake y,anker y,boje y,lm y,=by,=ly,=ay"),
    ("range", "=range,range,=r,=rho,=ρ,distance,dist,abstand,entfernung,distanz,portee,distancia,alcance,distanza"),
    (
        "bearing",
        "bearing,azimuth,=beta,=phi,=φ,phi,angle,peilung,winkel,gisement,relevement,marcacion,demora,angulo,\
         rilevamento,angolo",
    ),
    (
        "x",
        "=x,=tx,position x,p x,pos x,pose x,robot x,true x,truth x,gt x,translation x,utm x,gps x,gnss x,fix x,rtk x,\
         mocap x,vicon x,local x,nav x,laser x,lidar x,uwb x,camera x,x position,posizione x,posicion x,\
         east,easting,ost,rechtswert,est,este,gps e,gnss e,fix e,rtk e,utm e,enu e",
    ),
    (
        "y",
        "=y,=ty,position y,p y,pos y,pose y,robot y,true y,truth y,gt y,translation y,utm y,gps y,gnss y,fix y,rtk y,\
         mocap y,vicon y,local y,nav y,laser y,lidar y,uwb y,camera y,y position,posizione y,posicion y,\
         north,northing,nord,hochwert,norte,gps n,gnss n,fix n,rtk n,utm n,enu n",
    ),
    (
        "heading",
        "=heading,g crs,cog,course,=hdg,=theta,=θ,=yaw,heading,hdg,yaw,theta,θ,orientation,compass,azimuth,kurs,\
         ausrichtung,gierwinkel,richtung,=cap,cap,lacet,rumbo,guinada,orientacion,prua,rotta,imbardata,\
         orientamento,direction",
    ),
    ("latitude", "=lat,=latitude,latitude,lat,breite,breitengrad,latitud,latitudine"),
    ("longitude", "=lon,=lng,=longitude,longitude,lon,lng,long,lange,laenge,langengrad,longitud,longitudine"),
    (
        "sigma",
        "horizontal accuracy,position accuracy,position sigma,position std,gps sigma,gnss sigma,fix sigma,rtk sigma,\
         gps std,gnss std,rtk std,=sigma,=σ,=accuracy,=std,=hacc,=h acc,=eph,\
         =genauigkeit,=standardabweichung,=precision,=precisione,=desviacion,=ecart type,sigma position,sigma pos,\
         accuracy,genauigkeit,precision,precisione,standardabweichung,position covariance 0,position variance,\
         =variance,=var,=variance x,=var x,=cov x,=cov xx,=covariance xx,varianz",
    ),
    (
        "sigma of heading",
        "heading accuracy,bearing accuracy,course accuracy,yaw accuracy,heading sigma,sigma heading,heading std,\
         yaw std,=cov yawyaw,=cov yaw,=cov yaw yaw,heading variance,yaw variance",
    ),
    (
        "left",
        "left,links,linkes,gauche,izquierda,izquierdo,sinistra,sinistro,=l,=enc l,=encoder l,wheel l,=v l,=vl,\
         =vel l,=velocity l,=speed l,=omega l,=wl,=ticks l,=rpm l",
    ),
    (
        "right",
        "right,rechts,rechtes,droite,derecha,derecho,destra,destro,=r,=enc r,=encoder r,wheel r,=v r,=vr,\
         =vel r,=velocity r,=speed r,=omega r,=wr,=ticks r,=rpm r",
    ),
];

/// Words of a variance, whose root is a standard deviation.
pub(crate) const VARIANCES: [&str; 5] = ["covariance", "cov", "variance", "var", "varianz"];

/// Words that a column of a value has not.
pub(crate) const FORBIDDEN: [(&str, &[&str]); 13] = [
    ("time", &["nsec", "nsecs", "nanosec", "nanosecs", "usec", "usecs", "week", "frame", "first", "delta"]),
    (
        "omega",
        &["x", "y", "orientation", "quaternion", "linear", "bias", "integral", "left", "right", "roll", "pitch", "dt"],
    ),
    (
        "v",
        &[
            "angular",
            "rotational",
            "rotation",
            "yaw",
            "turn",
            "gyro",
            "y",
            "z",
            "north",
            "east",
            "down",
            "up",
            "n",
            "e",
            "d",
            "vertical",
            "left",
            "right",
            "angulaire",
            "lacet",
            "angolare",
            "rotazione",
            "giro",
            "imbardata",
            "rate",
            "links",
            "rechts",
            "vy",
            "vz",
            "sound",
            "wind",
            "max",
            "min",
            "roll",
            "pitch",
        ],
    ),
    ("distance", &["left", "right", "links", "rechts", "min", "max", "gauche", "droite"]),
    ("turn", &["rate", "velocity", "vel", "speed", "x", "y", "w", "vitesse", "velocidad", "velocita", "number"]),
    ("landmark", &["x", "y", "z", "range", "dist", "distance", "time", "frame"]),
    ("range", &["min", "max", "left", "right", "travelled", "traveled", "type"]),
    ("bearing", &["rate", "min", "max", "increment", "speed"]),
    ("x", &["velocity", "vel", "linear", "angular", "orientation", "quaternion", "gyro", "mag", "speed", "y", "z"]),
    ("y", &["velocity", "vel", "linear", "angular", "orientation", "quaternion", "gyro", "mag", "speed", "x", "z"]),
    (
        "heading",
        &[
            "rate",
            "velocity",
            "vel",
            "speed",
            "x",
            "y",
            "z",
            "w",
            "delta",
            "mag",
            "vitesse",
            "velocidad",
            "velocita",
            "sensor",
            "timestamp",
        ],
    ),
    ("sigma", &["heading", "bearing", "speed", "vertical", "yaw", "course", "range", "angle", "velocity", "direction"]),
    ("left", &["range", "distance", "camera", "image", "sonar", "ultrasonic"]),
];

/// Words of columns that are often beside a speed or a turn rate and hold neither.
pub(crate) const BESIDE: [&str; 44] = [
    "orientation",
    "quaternion",
    "linear",
    "angular",
    "covariance",
    "mag",
    "magnetic",
    "magnetometer",
    "seq",
    "frame",
    "frameid",
    "id",
    "stamp",
    "time",
    "timestamp",
    "sample",
    "roll",
    "pitch",
    "temperature",
    "temp",
    "altitude",
    "alt",
    "height",
    "elevation",
    "status",
    "satellites",
    "nsats",
    "sats",
    "voltage",
    "battery",
    "current",
    "x",
    "y",
    "i",
    "index",
    "row",
    "gyr",
    "gyro",
    "clip",
    "clipping",
    "calibration",
    "type",
    "absolute",
    "u",
];

/// The ways to say a value, the clearest first.
pub(crate) fn ways(value: &str) -> impl Iterator<Item = Way<'static>> + use<> {
    let all = WAYS.iter().find(|(name, _)| *name == value).map_or("", |(_, ways)| *ways);
    all.split(',').map(str::trim).filter(|way| !way.is_empty()).map(|way| {
        let whole = way.strip_prefix('=').map(Way::Whole);
        whole.or_else(|| way.strip_prefix('^').map(Way::First)).unwrap_or(Way::Within(way))
    })
}
